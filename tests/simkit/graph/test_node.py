"""Nodes in this process: names, timers, parameters, their end."""

import pytest

from simkit.errors import UnknownNameError
from simkit.graph import GraphError, LogLevel, ServiceFailed
from simkit.msgs import Duration, service_class

EMPTY = service_class("std_srvs/Empty")


def test_a_timer_calls_every_period_from_one_period_on(world):
    times = []
    world.node.create_timer(Duration(0, 30), lambda: times.append(world.executor.now_ns))
    world.executor.run_to(100)
    assert times == [30, 60, 90]


def test_a_timer_can_be_cancelled_in_its_own_callback(world):
    times = []

    def tick():
        times.append(world.executor.now_ns)
        if len(times) == 2:
            timer.cancel()

    timer = world.node.create_timer(Duration(0, 10), tick)
    world.executor.run_to(100)
    assert times == [10, 20]
    assert world.executor.next_time_ns() is None


def test_timers_of_one_instant_run_in_the_order_of_their_creation(world):
    seen = []
    for name in "abc":
        world.node.create_timer(Duration(0, 10), lambda name=name: seen.append(name))
    world.executor.run_to(20)
    assert "".join(seen) == "abcabc"


def test_names_resolve_in_the_node_and_follow_its_remappings(world):
    node = world.graph.create_node("/left/arm", {"/left/pose": "/elsewhere"})
    assert node.resolve("speed") == "/left/speed"
    assert node.resolve("~speed") == "/left/arm/speed"
    assert node.resolve("/speed") == "/speed"
    assert node.resolve("pose") == "/elsewhere"
    heard = world.hear("/elsewhere")
    node.advertise("pose", world.int32).publish(world.int32(7))
    world.run()
    assert heard == [7]
    with pytest.raises(GraphError, match="not a legal name"):
        node.resolve("two words")


def test_private_parameters_are_below_the_node(world):
    node = world.graph.create_node("/left/arm")
    node.set_param("~gain", 2.5)
    assert world.graph.params.get("/left/arm/gain") == 2.5
    assert node.has_param("~gain")
    assert node.get_param("~gain") == 2.5
    assert node.get_param("~other", "default") == "default"
    with pytest.raises(UnknownNameError, match="/left/arm/gain"):
        node.get_param("~gian")


def test_what_a_node_says_is_kept_with_level_and_time(world):
    world.executor.run_to(2_000_000_000)
    for say in (
        world.node.debug,
        world.node.info,
        world.node.warn,
        world.node.error,
        world.node.fatal,
    ):
        say("hello")
    records = world.graph.records
    assert [record.level for record in records] == list(LogLevel)
    assert {(record.node, record.time.to_sec(), record.text) for record in records} == {
        ("/tester", 2.0, "hello")
    }
    assert str(records[1]) == "[INFO] [2.000000] /tester: hello"


def _busy_node(world, name):
    node, seen = world.graph.create_node(name), []
    node.advertise("/said", world.int32)
    node.subscribe("/heard", world.int32, seen.append)
    node.advertise_service("~stop", EMPTY, lambda _: EMPTY._response_class())
    node.create_timer(Duration(0, 10), lambda: seen.append("tick"))
    node.on_shutdown(lambda: seen.append("goodbye"))
    return node, seen


def test_a_shut_down_node_leaves_nothing_behind(world):
    node, seen = _busy_node(world, "/busy")
    node.shutdown()
    node.shutdown()
    world.node.advertise("/heard", world.int32).publish(world.int32(1))
    world.run(1)
    assert seen == ["goodbye"]
    assert not node.alive
    assert list(world.graph.nodes) == ["/tester"]
    assert world.graph.services == {}
    assert world.graph.topic_types() == {"/heard": "std_msgs/Int32"}
    assert (node.publishers, node.subscriptions, node.servers) == ([], [], [])


def test_a_second_node_of_a_name_ends_the_first(world):
    older, seen = _busy_node(world, "/twin")
    newer = world.graph.create_node("/twin")
    assert (older.alive, newer.alive) == (False, True)
    assert seen == ["goodbye"]
    assert world.graph.nodes["/twin"] is newer
    assert world.said("WARN") == ["shutdown request: new node registered with same name"]
    older.shutdown()
    assert world.graph.nodes["/twin"] is newer


def test_a_reserved_name_cannot_be_taken(world):
    world.graph.reserved_names.add("/tester")
    with pytest.raises(GraphError, match="/tester is taken by the simulation"):
        world.graph.create_node("/tester")
    assert world.node.alive


@pytest.mark.parametrize("name", ["", "two words", "/a//b", "1st", "/a-b"])
def test_an_illegal_name_makes_no_node(world, name):
    with pytest.raises(GraphError, match="legal"):
        world.graph.create_node(name)


def test_a_node_in_a_service_may_call_another_service(world):
    def relay(_request):
        answers.append("outer")
        world.graph.call_service("/inner", b"", "/outer", lambda ok, _data: answers.append(ok))
        return EMPTY._response_class()

    def refuse(_request):
        raise ServiceFailed("no")

    answers = []
    world.node.advertise_service("/outer", EMPTY, relay)
    world.node.advertise_service("/inner", EMPTY, refuse)
    world.graph.call_service("/outer", b"", "/x", lambda ok, _data: answers.append(ok))
    world.run()
    assert answers == ["outer", True, False]
