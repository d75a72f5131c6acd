"""The warm parent of node processes: imports once, then forks a node in a few milliseconds.

It reads requests from one socket (a JSON line, file descriptors beside it) and answers with JSON lines. When that socket closes,
whatever the reason, it kills every process that came from it and exits: nobody is left behind. On Linux it is the reaper of
orphans too, so a process that a script detached from itself is found and killed.

Run as `python -m simkit.graph.process.zygote FD`.
"""

from __future__ import annotations

import contextlib
import ctypes
import errno
import gc
import importlib
import json
import os
import signal
import socket
import sys
import time
from dataclasses import asdict
from pathlib import Path
from typing import Any

from simkit.graph.process.child import make_modules_importable, run_node
from simkit.graph.process.spec import StartSpec
from simkit.graph.process.usage import usage_of

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
_PR_SET_CHILD_SUBREAPER = 36
_PR_SET_DUMPABLE = 4


class Zygote:
    """Serves the requests of one `NodeRuntime`."""

    def __init__(self, control: socket.socket) -> None:
        self._control = control
        self._nodes: set[int] = set()

    def serve(self) -> None:
        """Answer requests until the other end closes."""
        self._answer({"ready": True})
        while True:
            message, fds, _, _ = socket.recv_fds(self._control, 1 << 20, 3)
            if not message:
                return
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
            self._answer({"status": self._end(request["pid"], kill=request["kill"])})

    def _answer(self, value: dict[str, Any]) -> None:
        self._control.sendall(json.dumps(value).encode() + b"\n")

    def _start(self, request: dict[str, Any], fds: list[int]) -> None:
        try:
            pid = os.fork()
        except OSError as error:
            for fd in fds:
                os.close(fd)
            self._answer({"error": f"cannot start a process: {error.strerror}"})
            return
        if pid == 0:
            self._become_node(request, fds)
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
        """Reap a node (kill it first if asked) with everything that it left behind; its wait status."""
        if kill:
            _kill_group(pid)
        status = _reap(pid)
        _kill_group(pid)
        self._nodes.discard(pid)
        self._kill_orphans()
        return status

    def _kill_orphans(self) -> None:
        # As the reaper of orphans, whoever is our child and no node was detached by a script.
        for _ in range(1000):
            strays = [pid for pid in _children() if pid not in self._nodes]
            if not strays:
                return
            for pid in strays:
                with contextlib.suppress(ProcessLookupError, PermissionError):
                    os.kill(pid, signal.SIGKILL)
                _reap(pid)

    def end_all(self) -> None:
        """Kill every process that came from here."""
        for pid in list(self._nodes):
            self._end(pid, kill=True)
        self._kill_orphans()


def _kill_group(pid: int) -> None:
    for kill in (os.killpg, os.kill):
        with contextlib.suppress(ProcessLookupError, PermissionError):
            kill(pid, signal.SIGKILL)


def _reap(pid: int) -> int | None:
    deadline = time.monotonic() + 5.0
    while time.monotonic() < deadline:
        try:
            done, status = os.waitpid(pid, os.WNOHANG)
        except ChildProcessError:
            return None
        if done:
            return status
        time.sleep(0.0005)
    return None


def _children() -> list[int]:
    """Process ids of our children, as Linux tells them; empty elsewhere."""
    try:
        text = Path(f"/proc/self/task/{os.getpid()}/children").read_text()
        return sorted(int(pid) for pid in text.split())
    except OSError:
        return []


def _prctl(option: int, value: int) -> None:
    if sys.platform == "linux":
        with contextlib.suppress(OSError, AttributeError):
            ctypes.CDLL(None, use_errno=True).prctl(option, value, 0, 0, 0)


def main() -> None:
    """Entry point: the argument is the file descriptor of the control socket."""
    control = socket.socket(fileno=int(sys.argv[1]))
    os.set_inheritable(control.fileno(), False)
    _prctl(_PR_SET_CHILD_SUBREAPER, 1)
    _prctl(_PR_SET_DUMPABLE, 0)  # no script may look into this process
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
    gc.collect()
    gc.freeze()  # the nodes share these pages instead of copying them at the first collection
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
