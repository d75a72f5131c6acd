"""Entry of a node process that was not forked: connects back, proves itself by the token, runs the script.

Run as `python -m simkit.graph.process.spawned PORT`, token and start specification on standard input.
"""

from __future__ import annotations

import os
import socket
import sys

from simkit.graph.process.child import run_node
from simkit.graph.process.spec import StartSpec


def main() -> None:
    """Entry point: the argument is the port on the loopback interface."""
    token, _, spec = sys.stdin.buffer.read().partition(b"\n")
    connection = socket.create_connection(("127.0.0.1", int(sys.argv[1])))
    connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    connection.sendall(token)
    null = os.open(os.devnull, os.O_RDONLY)
    os.dup2(null, 0)
    sys.stdin = os.fdopen(0, encoding="utf-8", closefd=False)
    run_node(StartSpec.from_bytes(spec), connection, None)


if __name__ == "__main__":
    main()
