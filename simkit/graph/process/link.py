"""The wire between a node process and the graph: the end of the node, and that of the graph.

A node says what it has to say in one frame, and waits for one in answer. The graph's end also collects what the node
prints, and holds it to its allowance of wall time.
"""

from __future__ import annotations

import codecs
import contextlib
import os
import re
import socket
import sys
import time
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

from simkit.graph.process import protocol
from simkit.graph.process.fork_server import Source, readable
from simkit.graph.process.protocol import Op, Outbox

if TYPE_CHECKING:
    from simkit.graph.process.starters import StartedProcess

_FRAME_LINE = re.compile(
    r'^  File "(?P<file>[^"]+)", line (?P<line>[0-9]{1,9})(?: in (?P<function>.+))?$'
)

# -- node side


class Line:
    """A node process's wire to the graph.

    Args:
        connection: Connected stream socket; the graph is at the other end.
    """

    def __init__(self, connection: socket.socket) -> None:
        self.outbox = Outbox()
        """What the node has sent since its last turn."""
        self._connection = connection
        self._reader = protocol.FrameReader()

    def turn(self) -> Iterator[tuple[Op, bytes]]:
        """Send the records, wait for the graph, and give the records of its answer.

        The process ends here if the graph is gone: no thread of it has anything left to say.
        """
        try:
            self.send()
            frame = protocol.receive_frame(self._connection, self._reader)
        except OSError:
            frame = None
        if frame is None:
            os._exit(0)
        return protocol.records(frame)

    def send(self) -> None:
        """Send the records, after what the script has printed.

        Raises:
            OSError: The graph is gone.
        """
        _flush_output()
        self._connection.sendall(self.outbox.take())


def _flush_output() -> None:
    for stream in (sys.stdout, sys.stderr):
        try:
            stream.flush()
        except (AttributeError, OSError, ValueError):
            continue  # a script may close or replace its streams


# -- graph side


class Stuck(Exception):
    """The node neither blocked nor ended within its allowance."""


class Flooded(Exception):
    """The node printed more than it may."""


class Ended(Exception):
    """The node closed its end."""


STARVING = 3.0
"""So many times its allowance may a turn last if the machine is too busy to let the node compute."""
LEAST_WAIT = 0.05
"""A node that was kept from computing gets at least so much more time at once [s]."""


class NodeLink:
    """Sends and receives frames; collects what the node prints.

    Args:
        process: The started node.
        allowance: Time for one turn of the node [s]: on the wall, but what others took of a busy machine does not count.
        output_bytes: How much the node may print.
    """

    def __init__(self, process: StartedProcess, allowance: float, output_bytes: int) -> None:
        self._process = process
        self._allowance = allowance
        self._deadline = self._last_deadline = 0.0
        self._room = output_bytes
        self._frames = protocol.FrameReader()
        self._output_open = True
        self._connection = process.connection
        self._output = process.output
        self.output = bytearray()

    def begin_turn(self) -> None:
        """From now on the node's allowance runs, however many frames it sends."""
        now = time.monotonic()
        self._deadline = now + self._allowance
        self._last_deadline = now + STARVING * self._allowance

    def send(self, frame: bytes) -> None:
        """Send a frame; a node that does not read in time is stuck."""
        self._connection.settimeout(self._allowance)
        try:
            self._connection.sendall(frame)
        except TimeoutError as error:
            raise Stuck from error
        except OSError as error:
            raise Ended from error

    def receive(self) -> bytes:
        """The node's next frame.

        Raises:
            Stuck, Flooded, Ended: There will be none.
            ProtocolError: It is not a frame.
        """
        while (frame := self._frames.next_frame()) is None:
            timeout = self._deadline - time.monotonic()
            if timeout > 0:
                self._wait(timeout)
            else:
                self._extend()
        self.drain()
        return frame

    def drain(self) -> None:
        """Collect what the node has printed so far."""
        while self._output_open and readable([self._output], 0):
            self._read_output()

    def close(self) -> None:
        """Close our ends."""
        self._connection.close()
        if isinstance(self._output, socket.socket):
            self._output.close()
        elif self._output >= 0:
            os.close(self._output)
            self._output = -1
        if self._process.trace_fd is not None:
            os.close(self._process.trace_fd)
            self._process.trace_fd = None
        self._output_open = False

    def stack(self) -> list[tuple[str, int, str]]:
        """Where a stuck process is: (file, line, function) of its running thread, innermost first."""
        if self._process.trace_fd is None:
            return []
        self._process.ask_stack()
        text = _read_for(self._process.trace_fd, seconds=1.0)
        return most_telling_stack(text)

    def _extend(self) -> None:
        """More time for a node that would compute and could not have used up its allowance yet."""
        usage, now = self._process.usage(), time.monotonic()
        unused = self._allowance - usage.cpu_s if usage and usage.is_computing else 0.0
        if unused <= 0.0 or now >= self._last_deadline:
            raise Stuck
        self._deadline = min(now + max(unused, LEAST_WAIT), self._last_deadline)

    def _wait(self, timeout: float) -> None:
        watched: list[Source] = [self._connection]
        if self._output_open:
            watched.append(self._output)
        ready = readable(watched, timeout)
        if self._output in ready:
            self._read_output()
        if self._connection in ready:
            try:
                data = self._connection.recv(262144)
            except OSError as error:
                raise Ended from error
            if not data:
                raise Ended
            self._frames.feed(data)

    def _read_output(self) -> None:
        try:
            if isinstance(self._output, socket.socket):
                data = self._output.recv(65536)
            else:
                data = os.read(self._output, 65536)
        except OSError:
            data = b""
        if not data:
            self._output_open = False
            return
        self.output += data[: self._room]
        self._room -= len(data)
        if self._room < 0:
            self._output_open = False
            raise Flooded


def most_telling_stack(text: str) -> list[tuple[str, int, str]]:
    """Frames of the running thread in faulthandler's text, innermost first."""
    # The process may write here what it likes: nothing of it is taken at its word but as text of bounded length.
    stacks: list[tuple[bool, list[tuple[str, int, str]]]] = []
    for line in text.splitlines():
        if "hread 0x" in line:
            stacks.append((line.startswith("Current"), []))
        elif stacks and (match := _FRAME_LINE.match(line)):
            stacks[-1][1].append((match["file"], int(match["line"]), match["function"] or ""))
    for current, frames in stacks:
        if current:
            return frames
    return stacks[0][1] if stacks else []


def _read_for(fd: int, seconds: float) -> str:
    deadline = time.monotonic() + seconds
    data = b""
    while (left := deadline - time.monotonic()) > 0:
        # The first piece may take a while; the rest follows at once.
        if not readable([fd], min(left, 0.05) if data else left):
            break
        with contextlib.suppress(OSError):
            piece = os.read(fd, 65536)
            if not piece:
                break
            data += piece
        if len(data) > 1_000_000:
            break
    return data.decode(errors="replace")


class Printout:
    """What one script has printed, standard output and error in one.

    Args:
        show: Shows a text to a person.
    """

    def __init__(self, show: Callable[[str], None]) -> None:
        self.data = bytearray()
        """What has come so far; its link fills it."""
        self._show = show
        self._decoder = codecs.getincrementaldecoder("utf-8")("replace")
        self._shown = 0

    @property
    def text(self) -> str:
        """All of it."""
        return self.data.decode("utf-8", "replace")

    def show_new_text(self) -> None:
        """Show what has come since the last call; half a character waits for its other half."""
        if self._shown < len(self.data):
            text = self._decoder.decode(self.data[self._shown :])
            self._shown = len(self.data)
            if text:
                self._show(text)
