"""What a launch file comes to: parameters to set and nodes to start, in the order of the file."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal

from simkit.diagnostics import Diagnostic
from simkit.xml import Span

TEXT_NAME = "string"
"""What roslaunch calls a launch file that was given as a text."""


@dataclass(frozen=True, slots=True, kw_only=True)
class PlannedNode:
    """One `<node>`."""

    name: str
    """Its name without namespace, e.g. `listener`."""
    namespace: str
    """Namespace it is in, with a slash at both ends: `/` or `/robot/`."""
    package: str
    """Package of its program."""
    type: str
    """Its program: a script's file name or a built-in node."""
    args: str = ""
    """Its command line, as one text."""
    remappings: tuple[tuple[str, str], ...] = ()
    """From and to of each `<remap>`."""
    environment: tuple[tuple[str, str], ...] = ()
    """Name and value of each `<env>`."""
    output: Literal["log", "screen"] = "log"
    """Whether what it prints is for the screen."""
    respawn: bool = False
    """Whether it is started again when it ends."""
    respawn_delay: float = 0.0
    """Virtual time between its end and its new start [s]."""
    required: bool = False
    """Whether everything ends with it."""
    launch_prefix: str = ""
    """Command to run it under; without effect here."""
    file: str = ""
    """Launch file it comes from, as roslaunch names it."""
    shown_file: str = ""
    """The same file, as it is shown to people."""
    span: Span = field(default_factory=lambda: Span(1, 1))
    """Where it stands in that file."""

    @property
    def resolved_name(self) -> str:
        """Its global name, e.g. `/robot/listener`."""
        return self.namespace + self.name


@dataclass(frozen=True, slots=True, kw_only=True)
class Origin:
    """Where a parameter comes from."""

    shown_file: str
    """Launch file, as it is shown to people."""
    span: Span
    """Where its tag stands in it."""
    source: Path | None = None
    """File that its text was read from (`textfile=`, `cat`, ...); None if there is none."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ParameterStep:
    """A `<rosparam>` that deletes or dumps: done before any parameter is set."""

    command: Literal["delete", "dump"]
    """What to do."""
    name: str
    """Global name of the parameter or namespace."""
    file: str | None = None
    """File to dump to."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ArgumentDoc:
    """An argument that the file declares."""

    name: str
    """Its name."""
    default: str | None
    """Its default; None for one that must be given."""
    doc: str | None
    """What the file says about it."""


@dataclass(frozen=True, slots=True, kw_only=True)
class LaunchPlan:
    """What a launch file comes to."""

    file: str
    """The launch file, as roslaunch names it."""
    shown_file: str
    """The same, as it is shown to people, e.g. `hello_ros/launch/urdf_launch_1.launch`."""
    given: Mapping[str, str] = field(default_factory=dict)
    """Values that its arguments were given."""
    files: tuple[str, ...] = ()
    """All launch files that were read, in order, each as often as it was."""
    params: Mapping[str, Any] = field(default_factory=dict)
    """Parameters by global name, in order; of several tags for one name the last one's value."""
    origins: Mapping[str, Origin] = field(default_factory=dict)
    """Where each parameter comes from."""
    clear_params: tuple[str, ...] = ()
    """Namespaces that are emptied before."""
    steps: tuple[ParameterStep, ...] = ()
    """What is deleted or dumped before."""
    nodes: tuple[PlannedNode, ...] = ()
    """Nodes in the order of the file."""
    arguments: tuple[ArgumentDoc, ...] = ()
    """Arguments of the file itself, in order."""
    warnings: tuple[str, ...] = ()
    """What roslaunch prints about things that it does not understand, a line or more each."""
    diagnostics: tuple[Diagnostic, ...] = ()
    """What a teacher says about a file that works, by place."""
