"""The fork server of checkers: imports once, then forks a guard for each job, and the guard a checker.

The guard holds the lifeline to the runner. When the checker ends, or the lifeline closes (its time
is over, or the runner is gone, whatever the reason), the guard kills every process that came from
the checker, also those that detached themselves, and tells how the checker ended.

While the first jobs run, the server imports what checkers import late, a module at a time: the first
job need not wait for it, and the later ones find it done.

Run as `python -m grader.run.warm FD`.
"""

from __future__ import annotations

import contextlib
import importlib
import json
import os
import select
import shutil
import signal
import socket
import sys

from grader.run.checker import work
from grader.run.launch import read_framed
from simkit.graph.process import (
    become_reaper,
    each_request,
    end_tree,
    end_with_parent,
    fork_task,
    share_memory,
)

LATE = (
    "simkit.launch.launch",
    "simkit.nodes.turtlesim",
    "simkit.nodes.robot_state_publisher",
    "simkit.nodes.joint_state_publisher",
    "simkit.urdf.rules.check",
    "numpy",
    "dartpy",
    "simkit.gazebo.gzserver",
    "simkit.gazebo.spawn_model",
    "simkit.nodes.controller_manager",
    "simkit.plugins.control.plugin",
    "simkit.plugins.diff_drive",
    "simkit.plugins.laser",
)
"""What the checks of one exercise or another import when they need it."""


def main() -> None:
    """Serve jobs until the runner closes the control socket."""
    control = socket.socket(fileno=int(sys.argv[1]))
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the runner, which then closes us
    signal.signal(signal.SIGCHLD, signal.SIG_IGN)  # guards leave no zombies
    late = list(LATE)
    share_memory()
    for _, fds in each_request(control):
        fork_task(_guard_of, control, fds)
        for fd in fds:
            os.close(fd)
        _import_while_idle(late, control)


def _import_while_idle(late: list[str], control: socket.socket) -> None:
    """Import one module after the other until a job comes; what cannot be imported is the checkers' business."""
    if not late:
        return
    while late and not select.select([control], [], [], 0)[0]:
        with contextlib.suppress(ImportError):
            importlib.import_module(late.pop(0))
    if not late:
        share_memory()


def _guard_of(control: socket.socket, fds: list[int]) -> None:
    control.close()
    for fd in fds:
        os.set_inheritable(fd, False)
    guard(socket.socket(fileno=fds[0]), fds[1], fds[2])


def guard(lifeline: socket.socket, results: int, output: int) -> None:
    """Run one checker and end all that came from it.

    Args:
        lifeline: Brings the job; takes the exit code.
        results: File descriptor for the checker's events.
        output: File descriptor for what it prints.
    """
    os.setsid()  # away from the terminal's signals; no node inherits a file descriptor of ours
    signal.signal(signal.SIGCHLD, signal.SIG_DFL)
    become_reaper()
    job = read_framed(lifeline.recv)
    if job is None:
        return
    ended, alive = os.pipe()  # the checker keeps `alive` open for as long as it lives
    checker = fork_task(_become_checker, lifeline, job, results, output)
    for fd in (results, output, alive):
        os.close(fd)
    select.select([lifeline.fileno(), ended], [], [])
    exit_code = end_tree(checker)
    shutil.rmtree(json.loads(job)["folder"], ignore_errors=True)  # the runner may be gone
    with contextlib.suppress(OSError):
        lifeline.sendall(json.dumps({"exit_code": exit_code}).encode())


def _become_checker(lifeline: socket.socket, job: bytes, results: int, output: int) -> None:
    lifeline.close()
    end_with_parent()
    os.setsid()
    nothing = os.open(os.devnull, os.O_RDONLY)
    for source, target in ((nothing, 0), (output, 1), (output, 2)):
        os.dup2(source, target)
    work(job, results)


if __name__ == "__main__":
    main()
