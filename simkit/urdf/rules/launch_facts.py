"""What a launch file beside a URDF says, as far as it can be read without running it.

Nothing is substituted: a name or text with `$(...)` in it is not known here. `simkit.launch` evaluates launch files; the
rules only look for what is missing.
"""

from __future__ import annotations

import shlex
from dataclasses import dataclass

from simkit.urdf.rules.companion import Companion, CompanionKind
from simkit.urdf.rules.sheet import Sheet
from simkit.urdf.rules.values import read_number
from simkit.xml import Document, Element

DESCRIPTION = "robot_description"
"""The parameter that holds the URDF."""

_READERS = ("robot_state_publisher", "state_publisher", "joint_state_publisher", "joint_state_publisher_gui")  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class LaunchFile:
    """One launch file."""

    companion: Companion
    """The file."""
    document: Document
    """It as XML."""
    parameters: tuple[Element, ...]
    """Its `<param>`s outside of nodes."""
    nodes: tuple[Element, ...]
    """Its `<node>`s."""
    others: tuple[Element, ...]
    """What may set parameters in a way that is not seen here: `<include>`s and `<rosparam>`s."""

    def names(self) -> list[str]:
        """Names of its parameters, without a leading slash."""
        return [(one.get("name") or "").strip().lstrip("/") for one in self.parameters]

    def readers(self) -> list[tuple[Element, str]]:
        """Nodes that need a description, and the parameter that each takes it from."""
        found = []
        for node in self.nodes:
            if node.get("type") in _READERS:
                found.append((node, DESCRIPTION))
            elif node.get("type") == "spawn_model":
                name = option(node, "-param")
                if name is not None:
                    found.append((node, name.lstrip("/")))
        return found


def launch_files(sheet: Sheet) -> list[LaunchFile]:
    """The launch files beside a URDF."""
    return [_read(one) for one in sheet.companions if one.kind is CompanionKind.LAUNCH]


def option(node: Element, name: str) -> str | None:
    """The word behind an option in the `args` of a node: `-z 0.1`; None if it is not given."""
    words = _words(node.get("args") or "")
    place = words.index(name) if name in words[:-1] else None
    return None if place is None else words[place + 1]


def spawn_height(sheet: Sheet) -> float | None:
    """How high a launch file spawns the robot [m]; None if none spawns it, or the height is not known."""
    for launch in launch_files(sheet):
        for node in launch.nodes:
            if node.get("type") == "spawn_model":
                return read_number(option(node, "-z") or "0")
    return None


def is_known(text: str | None) -> bool:
    """Whether a text says what it means, without `$(...)`."""
    return text is not None and "$(" not in text


def _words(args: str) -> list[str]:
    try:
        return shlex.split(args)
    except ValueError:  # a quotation mark that is not closed
        return args.split()


def _read(companion: Companion) -> LaunchFile:
    document = companion.document()
    elements = [] if document.root is None else list(document.root.walk())
    in_nodes = {id(child) for one in elements if one.name == "node" for child in one.children}
    return LaunchFile(
        companion=companion,
        document=document,
        parameters=tuple(one for one in elements if one.name == "param" and id(one) not in in_nodes),
        nodes=tuple(one for one in elements if one.name == "node"),
        others=tuple(one for one in elements if one.name in ("include", "rosparam")),
    )  # fmt: skip
