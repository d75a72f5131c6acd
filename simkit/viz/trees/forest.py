"""The trees that a buffer holds, ready to be drawn: nodes in order, parents before children."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from simkit.tf import BufferCore
from simkit.tf.cache import StaticCache
from simkit.tf.frame_report import FrameReport, frame_reports
from simkit.tf.hints import two_trees_hint

_NAMED = 6
"So many roots are named in a sentence."


@dataclass(frozen=True, slots=True, kw_only=True)
class TreeNode:
    """A frame in a tree."""

    name: str
    """The frame."""
    parent: int | None
    """Number of its parent in the tree; None for the root."""
    report: FrameReport | None
    """What is known about the way to its parent; None for a root."""
    is_static: bool
    """Whether its transform holds at every time."""
    is_echo: bool = False
    """Whether it stands for a frame that is drawn further down: the top of a loop."""


@dataclass(frozen=True, slots=True, kw_only=True)
class FrameTree:
    """Frames that are connected."""

    nodes: tuple[TreeNode, ...]
    """The root, then everything below it; a parent comes before its children."""
    loop: tuple[str, ...] = ()
    """Frames that are their own ancestors, each followed by its parent; normally none."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Forest:
    """All trees of a buffer."""

    trees: tuple[FrameTree, ...]
    """The trees, in the order in which their roots were heard of."""
    warnings: tuple[str, ...]
    """Sentences on what is wrong with them as a whole."""

    @property
    def frame_count(self) -> int:
        """Number of frames."""
        return sum(not node.is_echo for tree in self.trees for node in tree.nodes)


def forest_of(core: BufferCore) -> Forest:
    """The trees of a buffer, by the newest transform of each frame."""
    parents = {frame: core.parent_of(frame) for frame in core.frame_strings}
    children: dict[str, list[str]] = {frame: [] for frame in parents}
    for frame, parent in parents.items():
        if parent is not None:
            children[parent].append(frame)
    grower = _Grower(core, children)
    trees = [grower.tree(frame) for frame, parent in parents.items() if parent is None]
    for frame in parents:
        if frame not in grower.seen:
            trees.append(grower.looped_tree(_loop_above(frame, parents)))
    return Forest(trees=tuple(trees), warnings=tuple(_warnings(core, trees)))


class _Grower:
    def __init__(self, core: BufferCore, children: Mapping[str, list[str]]) -> None:
        self._children = children
        self._reports = {report.name: report for report in frame_reports(core.frames)}
        self._static = {
            name
            for name in children
            if isinstance(core.frames.caches[core.frames.number(name)], StaticCache)
        }
        self.seen: set[str] = set()

    def tree(self, root: str) -> FrameTree:
        nodes: list[TreeNode] = []
        self._grow(nodes, root, None)
        return FrameTree(nodes=tuple(nodes))

    def looped_tree(self, loop: list[str]) -> FrameTree:
        start, parent = loop[0], loop[1 % len(loop)]
        echo = TreeNode(name=parent, parent=None, report=None, is_static=False, is_echo=True)
        nodes = [echo]
        self._grow(nodes, start, 0)
        return FrameTree(nodes=tuple(nodes), loop=tuple(loop))

    def _grow(self, nodes: list[TreeNode], root: str, above: int | None) -> None:
        waiting: list[tuple[str, int | None]] = [(root, above)]
        while waiting:
            name, parent = waiting.pop()
            self.seen.add(name)
            report, is_static = self._reports.get(name), name in self._static
            nodes.append(TreeNode(name=name, parent=parent, report=report, is_static=is_static))
            number = len(nodes) - 1
            unseen = [child for child in self._children[name] if child not in self.seen]
            waiting += [(child, number) for child in reversed(unseen)]


def _loop_above(frame: str, parents: Mapping[str, str | None]) -> list[str]:
    way: list[str] = []
    here: str | None = frame
    while here is not None and here not in way:
        way.append(here)
        here = parents[here]
    return way[way.index(here) :] if here is not None else way


def _warnings(core: BufferCore, trees: list[FrameTree]) -> list[str]:
    found = []
    for tree in trees:
        if tree.loop:
            way = " -> ".join(f'"{name}"' for name in (*tree.loop, tree.loop[0]))
            found.append(
                f'"{tree.loop[0]}" is its own ancestor: {way} (child -> parent). '
                "tf finds no way through a loop."
            )
    roots = [tree.nodes[0].name for tree in trees if not tree.loop]
    if len(roots) == 2:
        found.append(f"These trees are not connected. {two_trees_hint(core, *roots)}")
    elif len(trees) > 1:
        shown = ", ".join(f'"{root}"' for root in roots[:_NAMED])
        more = f" and {len(roots) - _NAMED} more" if len(roots) > _NAMED else ""
        found.append(
            f"These {len(trees)} trees are not connected: tf cannot say where a frame of one "
            f"is, seen from another. A frame without a parent: {shown}{more}."
        )
    return found
