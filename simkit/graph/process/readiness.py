"""Graph side: wait until something can be read."""

from __future__ import annotations

import math
import select
import socket
from collections.abc import Sequence

Source = socket.socket | int
"""What can be waited for: a socket, or (not on Windows) any file descriptor."""


def readable(sources: Sequence[Source], timeout: float) -> list[Source]:
    """Those of `sources` that can be read or have ended, after at most `timeout` [s]."""
    if not hasattr(select, "poll"):
        return list(select.select(sources, [], [], timeout)[0])
    # `select` cannot take descriptors beyond 1023, which a class of simulations in one process reaches.
    poll = select.poll()
    by_fd = {source if isinstance(source, int) else source.fileno(): source for source in sources}
    for fd in by_fd:
        poll.register(fd, select.POLLIN)
    return [by_fd[fd] for fd, _ in poll.poll(math.ceil(timeout * 1000))]
