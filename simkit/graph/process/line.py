"""Node side: the wire to the graph. What a node has said leaves in one frame; then the node waits for one in answer."""

from __future__ import annotations

import os
import socket
import sys
from collections.abc import Iterator

from simkit.graph.process import protocol
from simkit.graph.process.protocol import Op, Outbox


class Line:
    """A node process's wire to the graph.

    Args:
        connection: Connected stream socket; the graph is at the other end.
    """

    def __init__(self, connection: socket.socket) -> None:
        self.outbox = Outbox()
        """What the node has said since its last turn."""
        self._connection = connection
        self._reader = protocol.FrameReader()

    def turn(self) -> Iterator[tuple[Op, bytes]]:
        """Send what was said, wait for the graph, and give the records of its answer.

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
        """Send what was said, after what the script has printed.

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
