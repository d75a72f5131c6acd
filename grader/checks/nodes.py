"""The nodes that a check has started, and what became of them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import PurePosixPath
from typing import Any, Protocol

from grader.checks.values import bounded
from grader.errors import CheckFailed
from grader.exercises import Exercise
from grader.results import Status
from grader.submission import Submission
from simkit import Simulation
from simkit.graph import unmatched_topics
from simkit.graph.process import NodeFailure, Permissions, ScriptNode

_STATUSES = {"stuck": Status.TIMEOUT, "start": Status.INFRASTRUCTURE}
"""By kind of failure; any other is an error of the script."""


class NodeHandle(Protocol):
    """What is read of a node."""

    name: str
    alive: bool
    exit_code: int | None
    failure: NodeFailure | None
    refusals: list[str]


@dataclass(frozen=True, slots=True, kw_only=True)
class Trouble:
    """What went wrong in a node, in words for the student."""

    status: Status
    message: str


@dataclass(slots=True)
class NodeWatch:
    """The scripts that one check has started, in order."""

    nodes: list[tuple[str, Any]] = field(default_factory=list)
    """Script name and node handle."""
    launches: list[tuple[str, Any]] = field(default_factory=list)
    """Name of a launch file and its launch, whose nodes may be started again and again."""
    simulation: Simulation | None = None
    """Where they run; None as long as the check has asked for none."""

    def trouble(self) -> Trouble | None:
        """The first node that failed or was refused something; None if all went well."""
        for script, node in self._all_nodes():
            if node.failure is not None:
                return _failure(script, node.failure)
        for file, launch in self.launches:
            if launch.failures:
                message = bounded(f"{file}: {launch.failures[0]}", 600)
                return Trouble(status=Status.FAILED, message=message)
        refusal = self.refusal()
        return Trouble(status=Status.FAILED, message=refusal) if refusal else None

    def started(self) -> str:
        """The first script or launch file that was started; empty if there is none."""
        return next((name for name, _ in (*self.launches, *self.nodes)), "")

    def refusal(self) -> str:
        """What a node or launch file was refused first, as a sentence; empty if nothing."""
        refused = [
            f"{name}: {handle.refusals[0]}"
            for name, handle in (*self.launches, *self._all_nodes())
            if handle.refusals
        ]
        return refused[0] if refused else ""

    def early_ends(self) -> str:
        """A sentence about scripts that ended by themselves; empty if there are none."""
        ended = [
            script for script, node in self._all_nodes() if not node.alive and node.failure is None
        ]
        return f"note: {', '.join(ended)} had already ended by itself" if ended else ""

    def unmatched_topics(self) -> str:
        """A sentence about the first topic of a node whose name is near to one in use; empty if there is none."""
        graph = self.simulation.graph if self.simulation else None
        found = [
            sentence
            for script, node in self._all_nodes()
            if graph is not None and isinstance(node, ScriptNode) and node.alive
            for sentence in unmatched_topics(graph, node, f"note: your node {script}").values()
        ]
        return found[0] if found else ""

    def _all_nodes(self) -> list[tuple[str, Any]]:
        launched = [
            (planned.type, node) for _, launch in self.launches for planned, node in launch.handles
        ]
        return [*self.nodes, *launched]


def _failure(script: str, failure: NodeFailure) -> Trouble:
    place = f"{failure.file}:{failure.line}" if failure.file and failure.line else script
    function = failure.function if failure.function not in (None, "<module>") else None
    where = f"{place}, in {function}" if function else place
    what = bounded(failure.text.strip(), 600)
    if failure.kind == "exception":
        # %%writefile is the first line of a cell, and is not in the file.
        cell = f" (line {failure.line + 1} of the cell that writes it)" if failure.line else ""
        what = f"the script stopped with an error{cell}\n{what}"
    return Trouble(status=_STATUSES.get(failure.kind, Status.ERROR), message=f"{where}: {what}")


def permissions_of(exercise: Exercise) -> Permissions:
    """What the nodes of an exercise may write on the graph."""
    may = exercise.permissions
    return Permissions(
        publish=may.publish,
        services=may.services,
        parameters=may.parameters,
        nodes=may.launch,
    )


def require_handed_in(script: str, exercise: Exercise, submission: Submission) -> str:
    """The path of a script of the student, e.g. "hello_ros/scripts/listener.py".

    Args:
        script: File name, or path as in the exercise.
        exercise: What was asked for.
        submission: What was handed in.

    Raises:
        CheckFailed: It is not in the submission.
    """
    name = PurePosixPath(script).name
    found = [path for path in sorted(submission.files) if PurePosixPath(path).name == name]
    if found:
        return found[0]
    wanted = [path for path in exercise.files if PurePosixPath(path).name == name]
    path = wanted[0] if wanted else script
    raise CheckFailed(
        f"{name} was not handed in",
        expected=f"a cell that begins with %%writefile {path}",
        actual=_handed_in(sorted(submission.files)),
        hint="Write the file with the cell of the notebook, and save the notebook.",
    )


def _handed_in(files: Sequence[str]) -> str:
    return ", ".join(files[:10]) if files else "no file"
