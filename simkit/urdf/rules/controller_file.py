"""The controllers of a YAML file, with the places where they stand."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from simkit.urdf.rules.companion import Companion
from simkit.xml import Span

if TYPE_CHECKING:
    from yaml.nodes import Node

_DEEPEST = 6
"Controllers may stand in namespaces, but not in so many."
_MOST = 10_000


@dataclass(frozen=True, kw_only=True)
class Word:
    """A text in a YAML file."""

    text: str
    span: Span


@dataclass(frozen=True, kw_only=True)
class Controller:
    """One controller."""

    companion: Companion
    """The file."""
    name: Word
    """What it is called."""
    type: Word | None
    """Its type, e.g. `position_controllers/JointTrajectoryController`; None if it has none."""
    joints: tuple[Word, ...] | None
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


def controllers(companion: Companion) -> list[Controller] | Faulty:
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


def _walk(companion: Companion, root: Node | None) -> Iterator[Controller]:
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


def _controller(companion: Companion, name: Word, values: dict[str, Node]) -> Controller:
    kind = values.get("type")
    joints = values.get("joints") or values.get("joint")
    return Controller(
        companion=companion,
        name=name,
        type=None if kind is None else _word(kind),
        joints=None if joints is None else tuple(_words(joints)),
        keys=frozenset(values),
    )


def _items(node: Node) -> list[tuple[Word, Node]]:
    """The pairs of a mapping; none of anything else."""
    pairs = node.value if node.id == "mapping" else []
    return [(_word(key), value) for key, value in pairs if key.id == "scalar"]


def _words(node: Node) -> list[Word]:
    """The texts of a list, or the only one."""
    if node.id == "scalar":
        return [_word(node)] if node.value else []
    nodes = node.value if node.id == "sequence" else []
    return [_word(one) for one in nodes if one.id == "scalar"]


def _word(node: Node) -> Word:
    start, end = node.start_mark, node.end_mark
    length = end.column - start.column if end.line == start.line else 1
    text = node.value.strip() if isinstance(node.value, str) else ""
    return Word(text=text, span=Span(start.line + 1, start.column + 1, max(1, length)))
