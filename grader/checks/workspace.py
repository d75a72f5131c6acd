"""Where the student's files lie during a run of checks, and what starts them."""

from __future__ import annotations

import contextlib
from pathlib import Path

import pytest

from grader.checks.context import CheckContext, context_of
from grader.checks.layout import lay_out
from simkit.graph.process import NodeRuntime, StartError

ALLOWANCE = 5.0
"""Wall time for which a script of a student may compute without waiting [s]."""


class Workspace:
    """The student's files, laid out as ROS packages, and the sandbox that their nodes run in.

    Args:
        context: What the run is about.
    """

    def __init__(self, context: CheckContext) -> None:
        self.package_path = context.folder / "work"
        """Folder of the packages."""
        exercise, submission = context.exercise, context.submission
        lay_out(submission.files, self.package_path, package=exercise.package)
        self.runtime = _runtime(context, self.package_path)
        """Starts the student's nodes, in the sandbox and under its limits."""

    def warm_up(self) -> None:
        """Start now what nodes come from, beside what is done until the first one; a fault shows when it starts."""
        with contextlib.suppress(StartError):
            self.runtime.warm_up()


def _runtime(context: CheckContext, package_path: Path) -> NodeRuntime:
    home = context.folder / "home"
    home.mkdir(mode=0o777)
    home.chmod(0o777)  # not for anyone: the folder around it is closed
    confinement = context.sandbox.confine(package_path, home)
    return NodeRuntime(
        confinement.command_prefix,
        limits=confinement.limits,
        environment=confinement.environment,
        allowance=ALLOWANCE,
    )


_WORKSPACE: pytest.StashKey[Workspace] = pytest.StashKey()


def workspace_of(config: pytest.Config) -> Workspace:
    """The workspace of this pytest run, set up when it is first asked for."""
    if _WORKSPACE not in config.stash:
        config.stash[_WORKSPACE] = Workspace(context_of(config))
    return config.stash[_WORKSPACE]


def close_workspace(config: pytest.Config) -> None:
    """End all nodes of this pytest run."""
    if _WORKSPACE in config.stash:
        config.stash[_WORKSPACE].runtime.close()
