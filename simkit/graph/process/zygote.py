"""The fork server of node processes: imports once, then forks a node in a few milliseconds.

It reads requests from one socket (a JSON line, file descriptors beside it) and answers with JSON lines. When that socket closes,
whatever the reason, it kills every process that came from it and exits: nobody is left behind. On Linux it is the reaper of
orphans too, so a process that a script detached from itself is found and killed.

Run as `python -m simkit.graph.process.zygote FD`.
"""

from __future__ import annotations

import contextlib
import errno
import importlib
import json
import os
import signal
import socket
import sys
from dataclasses import asdict
from pathlib import Path
from typing import Any

from simkit.graph.process.child import make_modules_importable, run_node
from simkit.graph.process.fork_server import each_request, fork_task, share_memory
from simkit.graph.process.process_tree import (
    become_reaper,
    end_orphans,
    end_tree,
    hide_memory,
    usage_of,
    wait_for,
)
from simkit.graph.process.spec import StartSpec

# Not tf2_geometry_msgs: a script imports it for what its import does, and must not find that done.
PRELOAD = (
    "numpy",
    "numpy.random",
    "queue",
    "resource",
    "rospy",
    "tf",
    "tf2_ros",
    "geometry_msgs.msg",
    "std_msgs.msg",
    "turtlesim.msg",
    "turtlesim.srv",
)


class Zygote:
    """Serves the requests of one `NodeRuntime`."""

    def __init__(self, control: socket.socket) -> None:
        self._control = control
        self._nodes: set[int] = set()

    def serve(self) -> None:
        """Answer requests until the other end closes."""
        self._answer({"simkit": str(Path(__file__).resolve().parents[2])})
        for message, fds in each_request(self._control):
            self._handle(json.loads(message), fds)

    def _handle(self, request: dict[str, Any], fds: list[int]) -> None:
        if request["do"] == "start":
            self._start(request, fds)
        elif request["do"] == "signal":
            with contextlib.suppress(ProcessLookupError):
                os.kill(request["pid"], request["signal"])
            self._answer({})
        elif request["do"] == "usage":
            usage = usage_of(request["pid"])
            self._answer({"usage": usage and asdict(usage)})
        elif request["do"] == "end":
            self._answer({"code": self._end(request["pid"], kill=request["kill"])})

    def _answer(self, value: dict[str, Any]) -> None:
        self._control.sendall(json.dumps(value).encode() + b"\n")

    def _start(self, request: dict[str, Any], fds: list[int]) -> None:
        try:
            pid = fork_task(self._become_node, request, fds)
        except OSError as error:
            self._answer({"error": f"cannot start a process: {error.strerror}"})
            return
        finally:
            for fd in fds:
                os.close(fd)
        self._nodes.add(pid)
        self._answer({"pid": pid})

    def _become_node(self, request: dict[str, Any], fds: list[int]) -> None:
        try:
            self._control.close()
            os.setsid()
            connection_fd, output_fd, trace_fd = fds
            os.dup2(output_fd, 1)
            os.dup2(output_fd, 2)
            null = os.open(os.devnull, os.O_RDONLY)
            os.dup2(null, 0)
            for fd in (output_fd, null):
                os.close(fd)
            for fd in (connection_fd, trace_fd):
                os.set_inheritable(fd, False)  # a program that the script starts gets neither
            sys.stdout = os.fdopen(
                1, "w", buffering=1, encoding="utf-8", errors="replace", closefd=False
            )
            sys.stderr = os.fdopen(
                2, "w", buffering=1, encoding="utf-8", errors="replace", closefd=False
            )
            sys.stdin = os.fdopen(0, encoding="utf-8", closefd=False)
            run_node(
                StartSpec.from_bytes(json.dumps(request["spec"]).encode()),
                socket.socket(fileno=connection_fd),
                trace_fd,
            )
        except BaseException as error:
            print(f"the node process could not start: {error!r}", file=sys.stderr, flush=True)
        finally:
            os._exit(70)

    def _end(self, pid: int, *, kill: bool) -> int | None:
        """Reap a node (kill it first if asked) with everything that it left behind; its exit code."""
        self._nodes.discard(pid)
        code = None if kill else wait_for(pid)
        if code is None:
            code = end_tree(pid, spare=self._nodes)
        else:
            with contextlib.suppress(ProcessLookupError, PermissionError):
                os.killpg(pid, signal.SIGKILL)
        end_orphans(spare=self._nodes)
        return code

    def end_all(self) -> None:
        """Kill every process that came from here."""
        for pid in list(self._nodes):
            self._end(pid, kill=True)
        end_orphans(spare=())


def main() -> None:
    """Entry point: the argument is the file descriptor of the control socket."""
    control = socket.socket(fileno=int(sys.argv[1]))
    os.set_inheritable(control.fileno(), False)
    become_reaper()
    hide_memory()  # no script may look into this process
    signal.signal(
        signal.SIGINT, signal.SIG_IGN
    )  # Ctrl-C is for the simulation, which then closes us
    make_modules_importable()
    from simkit.graph.process import client

    with client.preloading():
        for name in PRELOAD:
            importlib.import_module(name)
    # A script may have a transformations.py of its own beside it; tf keeps the package.
    for name in [name for name in sys.modules if name.split(".")[0] == "transformations"]:
        del sys.modules[name]
    share_memory()
    zygote = Zygote(control)
    try:
        zygote.serve()
    except OSError as error:
        if error.errno not in (errno.EPIPE, errno.ECONNRESET):
            raise
    finally:
        zygote.end_all()


if __name__ == "__main__":
    main()
