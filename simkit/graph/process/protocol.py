"""What a node process and the graph say to each other.

One side at a time speaks, in *frames*; a frame is a length and a row of *records*; a record is an operation, a length and a
body. Control data is JSON, message bodies are ROS 1 wire format, nothing is ever unpickled. A node's frame ends with `WAIT`
(sleep until a virtual time or an event) or `ASK` (answer me now); the graph's frame ends with `RESUME` (virtual time is now t).

    node:   ADVERTISE ASK | PUBLISH PUBLISH WAIT(t+0.1) | CALL WAIT(never) ... EXIT
    graph:  REPLY RESUME(t)             | DELIVER RESUME(t)       | CALL_RESULT RESUME(t)
"""

from __future__ import annotations

import enum
import json
import socket
import struct
from collections.abc import Iterator
from typing import Any

MAX_FRAME = 64 * 1024 * 1024
"""Longest frame that either side accepts [bytes]."""
MAX_JSON = 8 * 1024 * 1024
"""Longest JSON body that the graph accepts [bytes]."""
MAX_DEPTH = 50
"""Deepest nesting of a JSON body."""
MAX_NAME = 4096
"""Longest node or topic name in a record [bytes]."""
LEAST_PERIOD_NS = 100_000
"""Nobody polls more often than this [ns]: each look is work for the graph."""
NEVER = -1
"""Wake-up time of a node that waits for events only."""

_LENGTH = struct.Struct("<I")
_RECORD = struct.Struct("<BI")
_TIME = struct.Struct("<q")
_LOOKS = struct.Struct("<qqq")
_ID = struct.Struct("<I")


class Op(enum.IntEnum):
    """Operations; the comment says who sends it and what its body is."""

    INIT_NODE = 1  # node: JSON {name, anonymous}; answered by REPLY
    ADVERTISE = 2  # node: JSON {topic, type, latch}; REPLY {id}
    UNADVERTISE = 3  # node: id
    PUBLISH = 4  # node: id, message
    SUBSCRIBE = 5  # node: JSON {topic, type, queue_size, stored}; REPLY {id}
    UNSUBSCRIBE = 6  # node: id
    OFFER_SERVICE = 7  # node: JSON {service, type}; REPLY {id}
    WITHDRAW_SERVICE = 8  # node: id
    SERVICE_ANSWER = 9  # node: call id, u8 success, response or error text
    CALL = 10  # node: call id, name length, service name, request
    PARAM = 11  # node: JSON {do, name, value}; REPLY
    LOG = 12  # node: u8 level, text
    QUERY = 13  # node: JSON {what, ...}; REPLY
    WAIT = 14  # node, last: wake-up time [ns] or NEVER; and if it polls: period, end
    ASK = 15  # node, last: the graph answers at once, no time passes
    EXIT = 16  # node, last: JSON {code, failure}
    FAULT = 17  # node: JSON failure of a callback; the node goes on
    REPLY = 32  # graph: JSON, {"error": sentence} when refused
    DELIVER = 33  # graph: subscription id, name length, publisher's node name, message
    CALL_RESULT = 34  # graph: call id, u8 success, response or error text
    SERVE = 35  # graph: call id, service id, name length, caller, request
    SHUTDOWN = 36  # graph: reason
    RESUME = 37  # graph, last: virtual time [ns]


class ProtocolError(Exception):
    """Bytes that are not of this protocol."""


class Outbox:
    """Records on their way into one frame."""

    __slots__ = ("_parts", "_size")

    def __init__(self) -> None:
        self._parts: list[bytes] = []
        self._size = 0

    def add(self, op: Op, *body: bytes) -> None:
        """Append a record."""
        size = sum(map(len, body))
        self._parts.append(_RECORD.pack(op, size))
        self._parts.extend(body)
        self._size += _RECORD.size + size
        if self._size > MAX_FRAME:
            raise ProtocolError(f"more than {MAX_FRAME} bytes were published at one instant")

    @property
    def is_empty(self) -> bool:
        """Whether nothing waits in it."""
        return not self._parts

    def has_room(self, size: int) -> bool:
        """Whether a record with a body of so many bytes still fits, with a little to spare for others."""
        return self._size + size <= MAX_FRAME - MAX_NAME

    def add_json(self, op: Op, value: Any) -> None:
        """Append a record with a JSON body."""
        self.add(op, json.dumps(value).encode())

    def take(self) -> bytes:
        """The frame, ready to send; the outbox is empty afterwards."""
        frame = b"".join([_LENGTH.pack(self._size), *self._parts])
        self._parts.clear()
        self._size = 0
        return frame


class FrameReader:
    """Cuts a byte stream into frames, with a bound on their length."""

    def __init__(self) -> None:
        self._data = bytearray()

    def feed(self, data: bytes) -> None:
        """Take bytes from the stream."""
        self._data += data

    def next_frame(self) -> bytes | None:
        """A whole frame's records, or None while it is not complete.

        Raises:
            ProtocolError: The frame says that it is longer than allowed.
        """
        if len(self._data) < _LENGTH.size:
            return None
        (length,) = _LENGTH.unpack_from(self._data)
        if length > MAX_FRAME:
            raise ProtocolError(f"a frame of {length} bytes; at most {MAX_FRAME} are allowed")
        end = _LENGTH.size + length
        if len(self._data) < end:
            return None
        frame = bytes(self._data[_LENGTH.size : end])
        del self._data[:end]
        return frame


def receive_frame(connection: socket.socket, reader: FrameReader) -> bytes | None:
    """Block until a whole frame is here; None at the end of the stream."""
    while (frame := reader.next_frame()) is None:
        data = connection.recv(65536)
        if not data:
            return None
        reader.feed(data)
    return frame


def records(frame: bytes) -> Iterator[tuple[Op, bytes]]:
    """The records of a frame.

    Raises:
        ProtocolError: A length or an operation is wrong.
    """
    offset = 0
    while offset < len(frame):
        if offset + _RECORD.size > len(frame):
            raise ProtocolError("a record is cut off")
        op, size = _RECORD.unpack_from(frame, offset)
        offset += _RECORD.size
        if offset + size > len(frame):
            raise ProtocolError("a record is longer than its frame")
        try:
            yield Op(op), frame[offset : offset + size]
        except ValueError as error:
            raise ProtocolError(f"{op} is no operation") from error
        offset += size


def pack_time(time_ns: int) -> bytes:
    """A virtual time [ns] as a record's body."""
    return _TIME.pack(time_ns)


def pack_looks(first_ns: int, period_ns: int, end_ns: int) -> bytes:
    """The body of a WAIT of a node that polls: when first, how often, until when [ns]."""
    return _LOOKS.pack(first_ns, period_ns, end_ns)


def unpack_looks(body: bytes) -> tuple[int, int, int]:
    """When a WAIT wants to be woken, how often it would look again if there is no news, until when [ns].

    Raises:
        ProtocolError: It is none.
    """
    if len(body) == _TIME.size:
        return unpack_time(body), 0, NEVER
    try:
        first_ns, period_ns, end_ns = _LOOKS.unpack(body)
    except struct.error as error:
        raise ProtocolError("not a time to wake up") from error
    if first_ns < 0 or period_ns < LEAST_PERIOD_NS:
        raise ProtocolError("polls without a beginning, or too often")
    return first_ns, period_ns, end_ns


def unpack_time(body: bytes) -> int:
    """The virtual time [ns] in a record's body."""
    try:
        return int(_TIME.unpack(body)[0])
    except struct.error as error:
        raise ProtocolError("not a time") from error


def pack_id(number: int) -> bytes:
    """An id as the beginning of a record's body."""
    return _ID.pack(number)


def unpack_id(body: bytes) -> tuple[int, bytes]:
    """The id at the beginning of a record's body, and the rest."""
    if len(body) < _ID.size:
        raise ProtocolError("an id is cut off")
    return _ID.unpack_from(body)[0], body[_ID.size :]


def pack_name(name: str) -> bytes:
    """A name with its length."""
    data = name.encode()
    return _ID.pack(len(data)) + data


def unpack_name(body: bytes) -> tuple[str, bytes]:
    """The name at the beginning of a record's body, and the rest."""
    length, rest = unpack_id(body)
    if length > min(MAX_NAME, len(rest)):
        raise ProtocolError("a name is too long")
    try:
        return rest[:length].decode(), rest[length:]
    except UnicodeDecodeError as error:
        raise ProtocolError("a name is not UTF-8") from error


def unpack_json(body: bytes) -> Any:
    """A record's JSON body: of bounded size and depth, and with nothing but characters in its texts.

    Raises:
        ProtocolError: It is not.
    """
    if len(body) > MAX_JSON:
        raise ProtocolError(f"a JSON body of {len(body)} bytes; at most {MAX_JSON} are allowed")
    try:
        value = json.loads(body.decode())
    except (ValueError, RecursionError) as error:
        raise ProtocolError("a record's body is not JSON") from error
    _require_plain(value, MAX_DEPTH)
    return value


def _require_plain(value: Any, depth: int) -> None:
    if isinstance(value, str):
        try:
            value.encode()  # JSON can spell half a character, which nobody can print
        except UnicodeEncodeError as error:
            raise ProtocolError("a text is not Unicode") from error
    elif isinstance(value, dict | list):
        if depth == 0:
            raise ProtocolError(f"a value is nested more than {MAX_DEPTH} times")
        for item in value:
            _require_plain(item, depth - 1)
        if isinstance(value, dict):
            for item in value.values():
                _require_plain(item, depth - 1)
