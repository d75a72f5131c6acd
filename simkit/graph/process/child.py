"""Node side: the life of a node process, from its start specification to its exit.

A fork server calls `run_node`. Where there is none, a fresh interpreter runs `python -m simkit.graph.process.child PORT`,
with a token and the start specification on standard input: it connects back, and proves itself by the token.
"""

from __future__ import annotations

import contextlib
import faulthandler
import os
import signal
import socket
import sys
import types
from pathlib import Path
from typing import Any

from simkit.graph.process import client as client_module
from simkit.graph.process.failure import describe, print_traceback
from simkit.graph.process.node_client import NodeClient
from simkit.graph.process.spec import StartSpec, apply_limits
from simkit.graph.process.virtual_time import seed_everything, virtualise_threading, virtualise_time

ROS1_FOLDER = str(Path(__file__).resolve().parents[2] / "ros1")


def run_node(spec: StartSpec, connection: socket.socket, trace_file: int | None) -> None:
    """Run a script as a node; ends the process.

    Args:
        spec: What to run.
        connection: Connected to the graph.
        trace_file: File descriptor for the stack of a stuck script.
    """
    _arm_stack_dump(trace_file)
    client = NodeClient(connection, spec.now_ns)
    client_module.connect(client)
    make_modules_importable()
    unfinished = virtualise_threading(client.scheduler)
    virtualise_time(
        client.now_ns, lambda seconds: client.sleep_until(client.peek_ns() + round(seconds * 1e9))
    )
    seed_everything(spec.seed)
    os.chdir(_working_directory(spec))
    apply_limits(spec.limits)
    _drop_privileges(spec.drop_to_uid)
    code, failure = _run_script(spec)
    with contextlib.suppress(BaseException):
        for task in unfinished():
            client.scheduler.join(task)
    _run_exit_hooks()
    with contextlib.suppress(OSError):
        client.finish(code, failure)
    os._exit(code & 0xFF)


def make_modules_importable() -> None:
    """Put rospy, tf and the message packages where `import` finds them."""
    if ROS1_FOLDER not in sys.path:
        sys.path.insert(0, ROS1_FOLDER)
    from simkit.ros1 import message_packages

    message_packages.install()


def _arm_stack_dump(trace_file: int | None) -> None:
    # SIGUSR1 asks a stuck process where it is; C code answers, whatever the Python code is doing.
    if trace_file is not None and hasattr(faulthandler, "register"):
        faulthandler.register(signal.SIGUSR1, file=trace_file, all_threads=True)


def _working_directory(spec: StartSpec) -> Path:
    # In a sandbox the package is read-only: a script that writes `open("log.txt", "w")` does so at its home.
    folder = Path(spec.working_directory or Path(spec.script).parent)
    home = Path(os.environ.get("HOME", folder))
    return folder if os.access(folder, os.W_OK) or not home.is_dir() else home


def _drop_privileges(uid: int | None) -> None:
    if uid is None or not hasattr(os, "setuid"):
        return
    os.setgroups([])
    os.setgid(uid)
    os.setuid(uid)


def _run_script(spec: StartSpec) -> tuple[int, dict[str, Any] | None]:
    """Exit code, and what went wrong (kind, text, file, line, function)."""
    main = types.ModuleType("__main__")
    main.__file__ = spec.shown_path
    main.__builtins__ = __builtins__  # type: ignore[attr-defined]
    sys.modules["__main__"] = main
    sys.argv = [spec.shown_path, *spec.arguments]
    # Behind the script's own folder, so that a helper beside the script is found.
    sys.path.insert(0, str(Path(spec.script).parent))
    try:
        source = Path(spec.script).read_bytes()
        exec(compile(source, spec.shown_path, "exec"), main.__dict__)
    except SystemExit as error:
        return _exit_code(error), None
    except BaseException as error:
        if isinstance(error, KeyboardInterrupt) and client_module.current().shutdown_reason:
            return 0, None  # a wait that the node's shutdown interrupted: the usual end of a loop
        print_traceback(error, sys.stderr)
        return 1, describe(error, spec.shown_path)
    return 0, None


def _exit_code(error: SystemExit) -> int:
    if error.code is None:
        return 0
    if isinstance(error.code, int):
        return error.code
    print(error.code, file=sys.stderr)
    return 1


def _run_exit_hooks() -> None:
    import atexit

    with contextlib.suppress(BaseException):
        atexit._run_exitfuncs()


def main() -> None:
    """Entry point of a fresh interpreter: the argument is the port on the loopback interface."""
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
