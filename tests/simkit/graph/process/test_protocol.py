"""Frames and records: what is packed comes out, and anything else is refused, never worse."""

import contextlib
import json
import struct

import pytest
from hypothesis import given
from hypothesis import strategies as st

from simkit.graph.process import protocol
from simkit.graph.process.protocol import FrameReader, Op, Outbox, ProtocolError

ops = st.sampled_from(list(Op))
rows = st.lists(st.tuples(ops, st.binary(max_size=40)), max_size=8)
json_values = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats(allow_nan=False) | st.text(),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(), inner, max_size=3),
    max_leaves=10,
)


def _frame(row):
    outbox = Outbox()
    for op, body in row:
        outbox.add(op, body)
    return outbox.take()


def _frames(reader):
    found = []
    while (frame := reader.next_frame()) is not None:
        found.append(frame)
    return found


@given(st.lists(rows, max_size=4), st.data())
def test_records_come_out_of_frames_that_are_cut_anywhere(sent, data):
    stream = b"".join(map(_frame, sent))
    cuts = data.draw(st.lists(st.integers(0, len(stream)), max_size=6).map(sorted))
    reader, received = FrameReader(), []
    for start, end in zip([0, *cuts], [*cuts, len(stream)], strict=True):
        reader.feed(stream[start:end])
        received += _frames(reader)
    assert [list(protocol.records(frame)) for frame in received] == sent


@given(st.binary(max_size=200))
def test_any_bytes_are_frames_or_refused(data):
    reader = FrameReader()
    reader.feed(data)
    with contextlib.suppress(ProtocolError):
        for frame in _frames(reader):
            for op, body in protocol.records(frame):
                assert isinstance(op, Op)
                assert isinstance(body, bytes)


UNPACKERS = (
    protocol.unpack_time,
    protocol.unpack_id,
    protocol.unpack_name,
    protocol.unpack_json,
)


@pytest.mark.parametrize("unpack", UNPACKERS)
@given(data=st.binary(max_size=60))
def test_any_body_is_read_or_refused(unpack, data):
    with contextlib.suppress(ProtocolError):
        unpack(data)


@given(st.integers(-(2**63), 2**63 - 1))
def test_times_round_trip(time_ns):
    assert protocol.unpack_time(protocol.pack_time(time_ns)) == time_ns


@given(st.integers(0, 2**32 - 1), st.text(max_size=50), st.binary(max_size=20))
def test_ids_and_names_round_trip(number, name, rest):
    assert protocol.unpack_id(protocol.pack_id(number) + rest) == (number, rest)
    assert protocol.unpack_name(protocol.pack_name(name) + rest) == (name, rest)


@given(json_values)
def test_json_round_trips(value):
    outbox = Outbox()
    outbox.add_json(Op.REPLY, value)
    ((op, body),) = protocol.records(outbox.take()[4:])
    assert op is Op.REPLY
    assert protocol.unpack_json(body) == value


def test_an_outbox_is_empty_once_it_is_taken():
    outbox = Outbox()
    outbox.add(Op.LOG, b"x")
    assert len(outbox.take()) == 4 + 5 + 1
    assert outbox.take() == b"\0\0\0\0"


def test_a_frame_that_says_it_is_huge_is_refused_before_it_comes():
    reader = FrameReader()
    reader.feed(struct.pack("<I", protocol.MAX_FRAME + 1))
    with pytest.raises(ProtocolError, match="at most"):
        reader.next_frame()


def test_more_than_a_frame_cannot_be_packed():
    outbox, piece = Outbox(), bytes(protocol.MAX_FRAME // 2)
    outbox.add(Op.PUBLISH, piece)
    assert not outbox.has_room(len(piece))
    with pytest.raises(ProtocolError, match="at one instant"):
        outbox.add(Op.PUBLISH, piece)


@pytest.mark.parametrize(
    "body",
    [
        pytest.param(b"[" * 100 + b"]" * 100, id="deep list"),
        pytest.param(b'{"a":' * 60 + b"1" + b"}" * 60, id="deep dict"),
        pytest.param(b"[" * 200_000, id="bottomless"),
        pytest.param(b'"' + b"x" * protocol.MAX_JSON + b'"', id="long"),
        pytest.param(rb'"\ud800"', id="half a character"),
        pytest.param(rb'{"\udfff": 1}', id="half a character in a key"),
        pytest.param(b"9" * 5000, id="endless number"),
        pytest.param("[1]".encode("utf-16"), id="utf-16"),
        pytest.param(b"", id="nothing"),
    ],
)
def test_json_that_would_hurt_is_refused(body):
    with pytest.raises(ProtocolError):
        protocol.unpack_json(body)


def test_json_may_be_as_deep_as_is_said():
    value = 1
    for _ in range(protocol.MAX_DEPTH):
        value = [value]
    assert protocol.unpack_json(json.dumps(value).encode()) == value


def test_a_long_name_is_refused():
    with pytest.raises(ProtocolError, match="name"):
        protocol.unpack_name(protocol.pack_name("x" * (protocol.MAX_NAME + 1)))
