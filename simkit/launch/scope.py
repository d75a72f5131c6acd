"""What holds at one place of a launch file: namespace, arguments, remappings, private parameters.

Source: roslaunch's `LoaderContext`. A group sees what was declared before it, and keeps what it declares to itself; an
included file sees only the arguments that it is given.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from simkit.graph.names import is_legal_name
from simkit.launch.errors import Kind, LaunchRefused, Lesson
from simkit.launch.launch_file import LaunchFile
from simkit.launch.rules import ARGUMENT, ATTRIBUTE


def name_in(namespace: str, name: str) -> str:
    """A name inside of a namespace, unless it is global or private."""
    if name[:1] in ("/", "~"):
        return name
    if namespace == "~":
        return f"~{name}"
    return f"{namespace.rstrip('/')}/{name}" if namespace else name


def tidy(name: str) -> str:
    """A name without doubled slashes and without one at its end."""
    if name in ("", "/"):
        return name
    return ("/" if name[0] == "/" else "") + "/".join(part for part in name.split("/") if part)


def as_namespace(name: str) -> str:
    """A name as a namespace: a slash before and behind it."""
    return "/" + name.strip("/") + "/" if name.strip("/") else "/"


@dataclass(slots=True)
class PrivateParameter:
    """A parameter with `~`, for all nodes that follow in its scope."""

    name: str
    value: Any
    source: Any = None


class Scope:
    """One scope.

    Args:
        launch_file: The file that it is in.
        namespace: With a slash before and behind.
        parent: The scope around it.
    """

    def __init__(
        self, launch_file: LaunchFile, namespace: str = "/", parent: Scope | None = None
    ) -> None:
        self.launch_file = launch_file
        self.namespace = namespace
        self.parent = parent
        self.arguments: dict[str, str] = {}
        self.declared: list[str] = []
        self.anonymous: dict[str, str] = {}
        self.given: dict[str, str] | None = None
        self.passes_all = False
        self.parameters: list[PrivateParameter] = []
        self.environment: list[tuple[str, str]] = []
        self._remappings: list[tuple[str, str]] = []
        if parent is not None:
            self._inherit(parent)

    def child(self, namespace: str | None = None) -> Scope:
        """A scope inside of this one.

        Args:
            namespace: Relative or global; None for the same.

        Raises:
            LaunchRefused: It is private.
        """
        if namespace == "~":
            what = "a namespace cannot be private"
            lesson = Lesson(rule=ATTRIBUTE, what=what, remedy="Write a name for ns=.")
            raise LaunchRefused(Kind.VALUE, "cannot turn [~] into a global name", lesson)
        inner = as_namespace(name_in(self.namespace, namespace)) if namespace else self.namespace
        return Scope(self.launch_file, inner, self)

    def for_include(self, namespace: str | None) -> Scope:
        """A scope in which the arguments for an included file are gathered."""
        scope = self.child(namespace)
        scope.declared = []
        scope.given = {}
        return scope

    def enter(self, launch_file: LaunchFile) -> list[str]:
        """Go over to the included file, which sees only what it was given.

        Returns:
            The names that it was given.

        Raises:
            LaunchRefused: One of them has no value.
        """
        assert self.given is not None
        for name in self.declared:
            if name not in self.given:
                what = f"the argument {name!r} for the included file has no value"
                remedy = f'Write <arg name="{name}" value="..."/>.'
                lesson = Lesson(rule=ARGUMENT, what=what, remedy=remedy)
                raise LaunchRefused(Kind.LOAD, "include args must have declared values", lesson)
        self.launch_file = launch_file
        self.arguments, self.given = self.given, None
        self.declared, self.anonymous = [], {}
        return list(self.arguments)

    def declare(self, name: str, *, value: str | None, default: str | None) -> None:
        """Declare an argument.

        Raises:
            LaunchRefused: It is declared already, or has a value that may not be replaced.
        """
        if name in self.declared:
            if not self.passes_all:
                raise _twice(name)
        else:
            self.declared.append(name)
        arguments = self.arguments if self.given is None else self.given
        if value is not None:
            if name in arguments and not self.passes_all:
                raise _fixed(name)
            arguments[name] = value
        elif default is not None:
            arguments.setdefault(name, default)

    def add_parameter(self, parameter: PrivateParameter) -> None:
        """Add a private parameter; it replaces one of the same name."""
        for other in [one for one in self.parameters if one.name == parameter.name]:
            self.parameters.remove(other)
        self.parameters.append(parameter)

    def add_remapping(self, source: str, target: str) -> None:
        """Add a remapping; it replaces one of the same source.

        Raises:
            LaunchRefused: A name is empty or not legal.
        """
        pair = (tidy(source), tidy(target))
        if not all(pair):
            raise _bad_remapping("remap from/to attributes cannot be empty", pair)
        for word, name in zip(("from", "to"), pair, strict=True):
            if not is_legal_name(name):
                raise _bad_remapping(f"remap {word} [{name}] is not a valid ROS name", pair)
        self._remappings = [one for one in self._remappings if one[0] != pair[0]]
        self._remappings.append(pair)

    def remappings(self) -> list[tuple[str, str]]:
        """Those of the scopes around it, the outermost first, and its own."""
        outer = [] if self.parent is None else self.parent.remappings()
        own = {source for source, _ in self._remappings}
        return [one for one in outer if one[0] not in own] + self._remappings

    def _inherit(self, parent: Scope) -> None:
        self.arguments = dict(parent.arguments)
        self.declared = list(parent.declared)
        self.anonymous = dict(parent.anonymous)
        self.given = parent.given
        # As in roslaunch: once there are private parameters, all scopes below share one list of them; only a
        # group gets a copy.
        self.parameters = parent.parameters or []
        self.environment = list(parent.environment)


def _twice(name: str) -> LaunchRefused:
    what = f"the argument {name!r} is declared twice"
    lesson = Lesson(rule=ARGUMENT, what=what, remedy="Remove one of the two.")
    return LaunchRefused(Kind.LOAD, f"arg '{name}' has already been declared", lesson)


def _fixed(name: str) -> LaunchRefused:
    what = f"the argument {name!r} has value=, so nobody can give it another one"
    remedy = f"Write default= in place of value= where {name!r} may be set from outside."
    lesson = Lesson(rule=ARGUMENT, what=what, remedy=remedy)
    return LaunchRefused(
        Kind.LOAD, f"cannot override arg '{name}', which has already been set", lesson
    )


def _bad_remapping(text: str, pair: tuple[str, str]) -> LaunchRefused:
    what = f"{pair[0]!r} cannot be remapped to {pair[1]!r}"
    remedy = "Write two names of topics or services: letters, digits, _ and / only."
    return LaunchRefused(Kind.LOAD, text, Lesson(rule=ATTRIBUTE, what=what, remedy=remedy))
