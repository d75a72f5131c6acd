"""What the files beside a URDF say: launch files, as far as they can be read without running them, and controllers."""

from __future__ import annotations

import shlex
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from simkit.urdf.rules.sheet import Companion, CompanionKind, Sheet
from simkit.urdf.rules.wording import read_number
from simkit.xml import Document, Element, Span

if TYPE_CHECKING:
    from yaml.nodes import Node

DESCRIPTION = "robot_description"
"""The parameter that holds the URDF."""

_READERS = ("robot_state_publisher", "state_publisher", "joint_state_publisher", "joint_state_publisher_gui")  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class CompanionLaunch:
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


def companion_launches(sheet: Sheet) -> list[CompanionLaunch]:
    """The launch files beside a URDF."""
    return [_read(one) for one in sheet.companions if one.kind is CompanionKind.LAUNCH]


def option(node: Element, name: str) -> str | None:
    """The word behind an option in the `args` of a node: `-z 0.1`; None if it is not given."""
    words = _words(node.get("args") or "")
    place = words.index(name) if name in words[:-1] else None
    return None if place is None else words[place + 1]


def spawn_height(sheet: Sheet) -> float | None:
    """How high a launch file spawns the robot [m]; None if none spawns it, or the height is not known."""
    for launch in companion_launches(sheet):
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


def _read(companion: Companion) -> CompanionLaunch:
    document = companion.document()
    elements = [] if document.root is None else list(document.root.walk())
    in_nodes = {id(child) for one in elements if one.name == "node" for child in one.children}
    return CompanionLaunch(
        companion=companion,
        document=document,
        parameters=tuple(one for one in elements if one.name == "param" and id(one) not in in_nodes),
        nodes=tuple(one for one in elements if one.name == "node"),
        others=tuple(one for one in elements if one.name in ("include", "rosparam")),
    )  # fmt: skip


_DEEPEST = 6
"Controllers may stand in namespaces, but not in so many."
_MOST = 10_000


@dataclass(frozen=True, kw_only=True)
class YamlText:
    """A text in a YAML file."""

    text: str
    span: Span


@dataclass(frozen=True, kw_only=True)
class ListedController:
    """One controller."""

    companion: Companion
    """The file."""
    name: YamlText
    """What it is called."""
    type: YamlText | None
    """Its type, e.g. `position_controllers/JointTrajectoryController`; None if it has none."""
    joints: tuple[YamlText, ...] | None
    """The joints that it moves; None if it names none."""
    keys: frozenset[str]
    """All words that it sets."""


@dataclass(frozen=True, kw_only=True)
class Faulty:
    """A YAML file that cannot be read."""

    problem: str
    """Why."""
    span: Span
    """Where."""


def listed_controllers(companion: Companion) -> list[ListedController] | Faulty:
    """The controllers of a file, in its order; never raises."""
    import yaml  # takes 20 ms to load, and most calls have no YAML

    try:
        root = yaml.compose(companion.text, Loader=yaml.SafeLoader)
    except yaml.MarkedYAMLError as error:
        mark = error.problem_mark or error.context_mark
        line, column = (1, 1) if mark is None else (mark.line + 1, mark.column + 1)
        return Faulty(problem=error.problem or "it cannot be read", span=Span(line, column))
    except (yaml.YAMLError, ValueError, RecursionError):
        return Faulty(problem="it cannot be read", span=Span(1, 1))
    return list(_walk(companion, root))


def gains_below(companion: Companion) -> bool:
    """Whether a file holds gains for Gazebo's own controllers of position and speed."""
    return "pid_gains" in companion.text


def _walk(companion: Companion, root: Node | None) -> Iterator[ListedController]:
    waiting = [] if root is None else [(name, node, 1) for name, node in _items(root)]
    waiting.reverse()
    seen = 0
    while waiting and seen < _MOST:
        seen += 1
        name, node, depth = waiting.pop()
        values = {key.text: value for key, value in _items(node)}
        if name.text in ("pid_gains", "gains", "constraints"):
            continue
        if "type" in values or "joints" in values or "joint" in values:
            yield _controller(companion, name, values)
        elif depth < _DEEPEST:
            waiting.extend((one, below, depth + 1) for one, below in reversed(_items(node)))


def _controller(companion: Companion, name: YamlText, values: dict[str, Node]) -> ListedController:
    kind = values.get("type")
    joints = values.get("joints") or values.get("joint")
    return ListedController(
        companion=companion,
        name=name,
        type=None if kind is None else _word(kind),
        joints=None if joints is None else tuple(_texts(joints)),
        keys=frozenset(values),
    )


def _items(node: Node) -> list[tuple[YamlText, Node]]:
    """The pairs of a mapping; none of anything else."""
    pairs = node.value if node.id == "mapping" else []
    return [(_word(key), value) for key, value in pairs if key.id == "scalar"]


def _texts(node: Node) -> list[YamlText]:
    """The texts of a list, or the only one."""
    if node.id == "scalar":
        return [_word(node)] if node.value else []
    nodes = node.value if node.id == "sequence" else []
    return [_word(one) for one in nodes if one.id == "scalar"]


def _word(node: Node) -> YamlText:
    start, end = node.start_mark, node.end_mark
    length = end.column - start.column if end.line == start.line else 1
    text = node.value.strip() if isinstance(node.value, str) else ""
    return YamlText(text=text, span=Span(start.line + 1, start.column + 1, max(1, length)))
