"""What has been gathered of a launch file so far."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from simkit.diagnostics import Diagnostic, Severity
from simkit.graph.params import why_unsendable
from simkit.launch.errors import Kind, LaunchPlace, LaunchRefused, Lesson, diagnostic_of, ours
from simkit.launch.files import Budget, Files
from simkit.launch.plan import ArgumentDoc, Origin, ParameterStep, PlannedNode
from simkit.launch.rules import ATTRIBUTE, YAML
from simkit.launch.scope import name_in, tidy
from simkit.launch.substitution import Substitution

MAX_WARNINGS = 200
"""So many warnings are kept."""


@dataclass(slots=True)
class LaunchState:
    """Parameters, nodes and warnings, in the order in which they were found."""

    files: Files
    budget: Budget
    substitution: Substitution
    params: dict[str, Any] = field(default_factory=dict)
    origins: dict[str, Origin] = field(default_factory=dict)
    places: dict[str, LaunchPlace] = field(default_factory=dict)
    clear_params: list[str] = field(default_factory=list)
    steps: list[ParameterStep] = field(default_factory=list)
    nodes: dict[str, PlannedNode] = field(default_factory=dict)
    machines: list[str] = field(default_factory=list)
    wanted_machines: list[tuple[str, LaunchPlace]] = field(default_factory=list)
    launch_files: list[str] = field(default_factory=list)
    arguments: list[ArgumentDoc] = field(default_factory=list)
    warnings: list[str] = field(default_factory=list)
    diagnostics: list[Diagnostic] = field(default_factory=list)

    def add_param(
        self, name: str, value: Any, place: LaunchPlace, source: Path | None = None
    ) -> None:
        """Add a parameter; the later one of two wins.

        Raises:
            LaunchRefused: ROS has no such values.
        """
        self.budget.tag()
        name = tidy(name)
        _require_a_name(name)
        _require_sendable(name, value)
        for parent in _above(name):
            if parent in self.params:
                self.warn(f"parameter [{name}] conflicts with parent parameter [{parent}]")
        self.params[name] = value
        self.places[name] = place
        self.origins[name] = Origin(
            shown_file=place.launch_file.document.file, span=place.span, source=source
        )

    def add_tree(
        self, name: str, value: Any, place: LaunchPlace, source: Path | None = None
    ) -> None:
        """Add a value of YAML: a mapping is a namespace.

        Raises:
            LaunchRefused: A key is no text, or ROS has no such values.
        """
        if not isinstance(value, dict):
            if tidy(name) == "/":
                words = "Cannot load non-dictionary types into global namespace '/'"
                raise LaunchRefused(Kind.VALUE, words, _no_mapping())
            self.add_param(name, value, place, source)
            return
        for key, part in value.items():
            if not isinstance(key, str) or not key:
                raise _bad_key(key)
            inner = key[1:] if key[0] == "~" else key
            self.add_tree(name_in(name, inner), part, place, source)

    def add_node(self, node: PlannedNode) -> None:
        """Add a node.

        Raises:
            LaunchRefused: There is one of its name.
        """
        name = node.resolved_name
        twin = self.nodes.get(name)
        if twin is not None:
            words = (
                f"roslaunch file contains multiple nodes named [{name}].\nPlease check all <node> 'name' "
                "attributes to make sure they are unique.\nAlso check that $(anon id) use different ids."
            )
            what = f"two nodes are named {name}; the first is at {twin.shown_file}:{twin.span.line}"
            lesson = Lesson(rule=ATTRIBUTE, what=what, remedy="Give each node a name of its own.")
            raise LaunchRefused(Kind.LOAD, words, lesson)
        self.nodes[name] = node

    def require_machines(self) -> None:
        """See that each machine that a node is meant for is there.

        Raises:
            LaunchRefused: One is not.
        """
        for name, place in self.wanted_machines:
            if name not in self.machines:
                what = f"there is no <machine> named {name!r}"
                remedy = "Remove machine=: all nodes run in this simulation."
                lesson = Lesson(rule=ATTRIBUTE, what=what, remedy=remedy)
                raise LaunchRefused(
                    Kind.LOAD, f"ERROR: unknown machine [{name}]", lesson, place=place
                )

    def warn(self, text: str, *, plain: bool = False) -> None:
        """Keep a warning of roslaunch.

        Args:
            text: Its words.
            plain: Whether roslaunch prints it as it is, without `WARNING: `.
        """
        if len(self.warnings) < MAX_WARNINGS:
            self.warnings.append(text if plain else f"WARNING: {text}")

    def teach(
        self, lesson: Lesson, place: LaunchPlace, severity: Severity = Severity.WARNING
    ) -> None:
        """Keep what a teacher says about something that works."""
        if len(self.diagnostics) < MAX_WARNINGS:
            self.diagnostics.append(diagnostic_of(lesson, place, severity))


def _require_a_name(name: str) -> None:
    """Refuse a value for the root of all parameters: the server would, when nobody knows the tag any more."""
    if name == "/":
        what = "a parameter without a name would be the root of all parameters"
        raise ours(ATTRIBUTE, what, 'Write a name, e.g. name="speed".')


def _above(name: str) -> list[str]:
    parts = name.split("/")[1:-1]
    return ["/" + "/".join(parts[: count + 1]) for count in range(len(parts))]


def _require_sendable(name: str, value: Any) -> None:
    """Refuse what roslaunch cannot send to the parameter server: it finds out when it tries."""
    found = why_unsendable(value)
    if found is not None:
        raise _unsendable(name, value, found.cause, found.what)


def _unsendable(name: str, value: Any, cause: str, what: str) -> LaunchRefused:
    words = f"load_parameters: unable to set params (last param was [{name}={value}]): {cause}"
    remedy = "Give a number, a text in quotation marks, true or false, or a list of those."
    lesson = Lesson(rule=YAML, what=f"{name}: {what}", remedy=remedy)
    return LaunchRefused(Kind.LOAD, words, lesson)


def _no_mapping() -> Lesson:
    what = "this YAML is no mapping of names to values, so its values have no names"
    return Lesson(
        rule=YAML, what=what, remedy='Write `name: value`, or give a name by param="...".'
    )


def _bad_key(key: object) -> LaunchRefused:
    words = f"{type(key).__name__!r} object is not subscriptable"
    what = f"{key!r} cannot be the name of a parameter"
    remedy = f'Put it in quotation marks: "{key}".' if key != "" else "Write a name."
    lesson = Lesson(rule=YAML, what=what, remedy=remedy)
    return LaunchRefused(Kind.OTHER, words, lesson, name="TypeError")
