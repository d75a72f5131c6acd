"""Whatever comes over a node's line, the graph and the other nodes go on."""

import json
import struct

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from simkit.graph.process import Permissions, protocol
from simkit.graph.process.protocol import NEVER, Op, Outbox
from simkit.msgs import message_class, service_class

WORDS = ("name", "topic", "type", "latch", "queue_size", "service", "do", "value", "what", "id")
MORE_WORDS = ("anonymous", "code", "failure", "text", "file", "line", "function")
VALUES = (
    *("set", "get", "has", "delete", "search", "names", "topics", "resolve", "connections"),
    *("std_msgs/Int32", "std_srvs/SetBool", "/numbers", "~x", "honest", "fake", "/", "a//b", ""),
)
leaves = (
    st.none()
    | st.booleans()
    | st.integers(-5, 5)
    | st.just(10**30)
    | st.floats()
    | st.sampled_from(VALUES)
    | st.text(max_size=5)
)
values = st.recursive(
    leaves,
    lambda inner: (
        st.lists(inner, max_size=3) | st.dictionaries(st.sampled_from(VALUES), inner, max_size=3)
    ),
    max_leaves=6,
)
requests = st.dictionaries(st.sampled_from(WORDS + MORE_WORDS), values, max_size=6).map(
    lambda value: json.dumps(value).encode()
)
ids = st.integers(0, 6).map(protocol.pack_id)
structured = st.builds(
    lambda parts, rest: b"".join(parts) + rest,
    st.lists(ids | st.sampled_from(VALUES).map(protocol.pack_name), max_size=3),
    st.binary(max_size=12),
)
bodies = requests | structured | st.binary(max_size=30)
GOOD = (
    (Op.INIT_NODE, {"name": "fake", "anonymous": True}),
    (Op.ADVERTISE, {"topic": "/numbers", "type": "std_msgs/Int32", "latch": True}),
    (Op.SUBSCRIBE, {"topic": "/numbers", "type": "std_msgs/Int32", "queue_size": 1}),
    (Op.OFFER_SERVICE, {"service": "/switch", "type": "std_srvs/SetBool"}),
    (Op.PARAM, {"do": "set", "name": "~x", "value": {"y": [1]}}),
    (Op.QUERY, {"what": "connections", "id": 1}),
    (Op.PUBLISH, protocol.pack_id(1) + bytes(4)),
    (Op.CALL, protocol.pack_id(7) + protocol.pack_name("/switch") + b"\x01"),
    (Op.SERVICE_ANSWER, protocol.pack_id(1) + b"\x01\x01" + bytes(4)),
    (Op.UNSUBSCRIBE, protocol.pack_id(2)),
    (Op.LOG, b"\x02hello"),
    (Op.FAULT, {"text": "x", "line": 3}),
)
good = st.sampled_from(
    [(op, body if isinstance(body, bytes) else json.dumps(body).encode()) for op, body in GOOD]
)
records = good | st.tuples(st.sampled_from(list(Op)) | st.integers(0, 255), bodies)
lasts = st.tuples(
    st.sampled_from((Op.WAIT, Op.ASK, Op.EXIT)),
    st.integers(-2, 10**7).map(protocol.pack_time)
    | st.builds(protocol.pack_looks, *[st.integers(-2, 10**7)] * 3)
    | bodies,
)


def _frame(row):
    packed = b"".join(struct.pack("<BI", op, len(body)) + body for op, body in row)
    return struct.pack("<I", len(packed)) + packed


frames = st.builds(lambda row, last: _frame([*row, last]), st.lists(records, max_size=6), lasts)


@settings(max_examples=200, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.lists(frames, max_size=6), st.binary(max_size=10))
def test_no_frames_break_the_graph(make_stage, sent, rest):
    stage = make_stage()
    stage.runtime.line.sendall(b"".join(sent) + rest)
    stage.runtime.line.shutdown(1)  # nothing follows: nobody waits for more
    stage.run(0.02)
    if stage.fake.failure is not None:
        str(stage.fake.failure).encode()
        assert stage.fake.failure.kind in ("exception", "exit", "protocol")
    stage.require_sound()
    stage.close()


def _outbox(*row):
    outbox = Outbox()
    for op, body in row:
        if isinstance(body, bytes):
            outbox.add(op, body)
        else:
            outbox.add_json(op, body)
    return outbox.take()


INIT = (Op.INIT_NODE, {"name": "fake", "anonymous": False})
SLEEP = (Op.WAIT, protocol.pack_time(NEVER))
ASK = (Op.ASK, b"")


def _play(stage, *turns, seconds=0.01):
    """Say one frame after another, each when the graph has answered the one before; then sleep on."""
    waiting = [_outbox(*turn) for turn in turns]
    stage.answer_with(lambda _data: waiting.pop(0) if waiting else _outbox(SLEEP))
    stage.run(seconds)


def test_a_node_that_asks_for_ever_is_stuck(make_stage):
    stage = make_stage(allowance=0.2)
    question = _outbox((Op.QUERY, {"what": "topics"}), ASK)
    stage.answer_with(lambda _data: question)
    stage.run(0.001)
    assert stage.fake.failure.kind == "stuck"
    stage.require_sound()


@pytest.mark.parametrize(
    ("period_ns", "end_ns"), [(100_000, 10**18), (10**18, 10**18), (100_000, -5)]
)
def test_a_node_that_looks_for_news_often_does_not_stop_the_clock(stage, period_ns, end_ns):
    looks = _outbox((Op.WAIT, protocol.pack_looks(500, period_ns, end_ns)))
    stage.answer_with(lambda _data: looks)
    stage.run(0.1)
    assert stage.graph.executor.now_ns == 100_000_000
    stage.require_sound()


@pytest.mark.parametrize("looks", [(500, 99_999, 10**9), (500, 0, 10**9), (-1, 10**6, 10**9)])
def test_a_node_that_looks_too_often_ends(stage, looks):
    stage.answer_with(lambda _data: _outbox((Op.WAIT, protocol.pack_looks(*looks))))
    stage.run(0.001)
    assert stage.fake.failure is not None
    stage.require_sound()


@pytest.mark.parametrize("wake_ns", [0, -7, -(2**63)])
def test_a_node_that_never_lets_time_pass_does_not_stop_the_clock(stage, wake_ns):
    stage.answer_with(lambda _data: _outbox((Op.WAIT, protocol.pack_time(wake_ns))))
    stage.run(0.0035)
    assert stage.graph.executor.now_ns == 3_500_000
    stage.require_sound()


def test_a_process_is_one_node_only(stage):
    _play(stage, [INIT, ASK], [(Op.INIT_NODE, {"name": "other", "anonymous": False}), ASK])
    assert stage.fake.failure.kind == "protocol"
    assert sorted(stage.graph.nodes) == ["/honest"]


def test_the_name_of_the_simulation_cannot_be_taken(stage):
    stage.graph.reserved_names.add("/honest")
    _play(stage, [(Op.INIT_NODE, {"name": "honest", "anonymous": False}), ASK], [SLEEP])
    assert stage.fake.name == "/fake"
    assert stage.graph.nodes == {"/honest": stage.honest}


def test_an_illegal_service_name_fails_the_call_only(stage):
    call = protocol.pack_id(1) + protocol.pack_name("not a name")
    _play(stage, [INIT, ASK], [(Op.CALL, call), SLEEP])
    assert stage.fake.alive


SERVICE = {"service": "/switch", "type": "std_srvs/SetBool"}


@pytest.mark.parametrize("answer", [b"", b"\x01", b"\x01\x01\xff\xff\xff\xff", b"\x01" + b"x" * 90])
def test_a_malformed_answer_reaches_nobody(stage, answer):
    request, answers = service_class("std_srvs/SetBool")._request_class(), []
    turn = (Op.SERVICE_ANSWER, protocol.pack_id(1) + answer)
    _play(stage, [INIT, ASK], [(Op.OFFER_SERVICE, SERVICE), ASK], [SLEEP], [turn, SLEEP], seconds=0)
    stage.graph.call_service(
        "/switch", request.to_bytes(), "/honest", lambda *pair: answers.append(pair)
    )
    stage.run(0.01)
    ((success, _text),) = answers
    assert not success
    stage.require_sound()


def test_calls_of_a_server_that_dies_fail(stage):
    request, answers = service_class("std_srvs/SetBool")._request_class(), []
    _play(stage, [INIT, ASK], [(Op.OFFER_SERVICE, SERVICE), ASK], [SLEEP], seconds=0)
    for _ in range(2):
        stage.graph.call_service(
            "/switch", request.to_bytes(), "/honest", lambda *pair: answers.append(pair)
        )
    stage.graph.executor.call_at(500, lambda: stage.fake.close())
    stage.run(0.01)
    text = b"transport error completing service call: the server has ended"
    assert answers == [(False, text)] * 2


def test_a_reader_of_too_much_loses_messages_and_lives(stage):
    array = message_class("std_msgs/UInt8MultiArray")
    subscribe = {"topic": "/big", "type": array._type, "queue_size": None}
    _play(stage, [INIT, ASK], [(Op.SUBSCRIBE, subscribe), ASK], [SLEEP], seconds=0)
    big, publisher = array(), stage.honest.advertise("/big", array)
    big.data = bytes(20 * 1024 * 1024)
    for _ in range(4):
        publisher.publish(big)
    executor = stage.graph.executor
    while not any("are lost" in record.text for record in stage.graph.records):
        executor.step()
    assert stage.fake.alive
    stage.fake.outbox.take()  # nobody reads it here


def test_a_message_that_is_none_ends_its_sender_only(stage):
    advertise = {"topic": "/numbers", "type": "std_msgs/Int32", "latch": False}
    publish = (Op.PUBLISH, protocol.pack_id(1) + b"xyz")
    _play(stage, [INIT, ASK], [(Op.ADVERTISE, advertise), ASK], [publish, SLEEP])
    assert stage.fake.failure.kind == "protocol"
    assert "/numbers is malformed" in stage.fake.failure.text
    stage.require_sound()


def test_many_parameters_and_much_talk_have_an_end(stage):
    text = "x" * 4_000_000
    setting = [(Op.PARAM, {"do": "set", "name": f"/p{i}", "value": text}) for i in range(15)]
    _play(stage, [INIT, ASK], [*setting, ASK], [*setting, ASK], [SLEEP], seconds=0.0)
    assert 10 < len(stage.graph.params.names()) < 20
    assert stage.fake.alive
    stage.require_sound()


def test_the_log_of_a_node_has_an_end(stage):
    line = (Op.LOG, b"\x02" + b"x" * 9_000)
    _play(stage, [INIT, ASK], [*[line] * 6000, SLEEP], [*[line] * 6000, SLEEP], seconds=0.0)
    stage.fake.resume_soon()
    stage.run(0.001)
    texts = [record.text for record in stage.graph.records if record.node == "/fake"]
    assert 6000 < len(texts) < 8000
    assert "no more is kept" in texts[-1]


def test_what_is_refused_is_refused_also_to_who_speaks_the_protocol(make_stage):
    stage = make_stage(permissions=Permissions(publish=("/tf",), services=(), parameters=()))
    advertise = {"topic": "/numbers", "type": "std_msgs/Int32", "latch": False}
    _play(
        stage,
        [INIT, ASK],
        [(Op.ADVERTISE, advertise), ASK],
        [(Op.PUBLISH, protocol.pack_id(1) + stage.number(1).to_bytes()), SLEEP],
        [(Op.PARAM, {"do": "set", "name": "/x", "value": 1}), ASK],
    )
    assert stage.heard == []
    assert stage.fake.refusals
    assert not stage.graph.params.has("/x")


def test_more_endpoints_than_anyone_needs_are_refused(stage):
    subscribe = (Op.SUBSCRIBE, {"topic": "/t", "type": "std_msgs/Int32", "queue_size": None})
    _play(stage, [INIT, ASK], [*[subscribe] * 1100, ASK], [SLEEP])
    assert len(stage.fake.subscriptions) == 1000
    assert stage.fake.alive
