"""Services in this process."""

import pytest

from simkit.errors import UnknownNameError
from simkit.graph import ServiceFailed
from simkit.msgs import service_class

SET_BOOL = service_class("std_srvs/SetBool")


@pytest.fixture
def call(world):
    """A function that calls a service: (success, response or error text)."""

    def call(name, request=None, data=None):
        answers = []
        body = (request or SET_BOOL._request_class()).to_bytes() if data is None else data
        world.graph.call_service(name, body, "/caller", lambda *answer: answers.append(answer))
        world.run()
        ((success, answer),) = answers
        if success:
            return True, SET_BOOL._response_class.from_bytes(answer)
        return False, answer.decode()

    return call


def _answering(message):
    return lambda _request: SET_BOOL._response_class(success=True, message=message)


def test_a_call_is_answered_within_its_instant(world, call):
    seen = []

    def handle(request):
        seen.append((request.data, request._connection_header["callerid"]))
        return SET_BOOL._response_class(success=not request.data, message="turned")

    world.node.advertise_service("/switch", SET_BOOL, handle)
    success, response = call("/switch", SET_BOOL._request_class(True))
    assert success
    assert (response.success, response.message) == (False, "turned")
    assert seen == [(True, "/caller")]
    assert world.executor.now_ns == 0


def test_a_server_may_refuse_with_a_text(world, call):
    def refuse(_request):
        raise ServiceFailed("not today")

    world.node.advertise_service("/switch", SET_BOOL, refuse)
    assert call("/switch") == (False, "not today")


def test_a_request_that_is_no_request_fails_the_call_only(world, call):
    world.node.advertise_service("/switch", SET_BOOL, _answering("never"))
    success, text = call("/switch", data=b"far too many bytes")
    assert not success
    assert "SetBoolRequest" in text


def test_a_service_that_nobody_offers_names_near_ones(world, call):
    world.node.advertise_service("/switch", SET_BOOL, _answering("x"))
    with pytest.raises(UnknownNameError, match="did you mean '/switch'"):
        call("/swich")


def test_the_newest_server_of_a_name_answers_and_only_it_can_withdraw_the_name(world, call):
    older = world.node.advertise_service("/switch", SET_BOOL, _answering("older"))
    newer = world.graph.create_node("/newer").advertise_service(
        "/switch", SET_BOOL, _answering("newer")
    )
    assert call("/switch")[1].message == "newer"
    older.shutdown()
    assert call("/switch")[1].message == "newer"
    newer.shutdown()
    newer.shutdown()
    with pytest.raises(UnknownNameError):
        call("/switch")


def test_a_node_forgets_the_servers_that_it_closes(world):
    for _ in range(3):
        server = world.node.advertise_service("/switch", SET_BOOL, _answering("x"))
        assert world.node.servers == [server]
        server.shutdown()
    assert world.node.servers == []
