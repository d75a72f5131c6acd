"""view_frames: the tree of frames, with what is known about each transform, as a picture and for graphviz."""

from __future__ import annotations

from collections.abc import Sequence

from simkit.msgs import Time
from simkit.tf import Buffer
from simkit.tf.frame_report import FrameReport
from simkit.viz.draw.drawing import Drawing, Label, Point, RoundedBox, Shape
from simkit.viz.draw.files import Formats
from simkit.viz.draw.letters import abbreviated, text_width, wrapped
from simkit.viz.trees.drawing import (
    GREY,
    INK,
    MARGIN,
    PAPER,
    READABLE_WIDTH,
    SMALL,
    TreePicture,
    dot_escaped,
    dot_quoted,
    key_of_broken_lines,
    tree_shapes,
)
from simkit.viz.trees.forest import Forest, FrameTree, forest_of
from simkit.viz.trees.layout import LONGEST, CardNode, TreeLayout, tree_layout

_GAP = 20.0
_LEAST_WIDTH = 420.0
_PANEL, _PANEL_EDGE = "#f7f9fc", "#d9e1ea"
_WARNING, _WARNING_EDGE, _WARNING_INK = "#fff6e0", "#e4b343", "#6b4700"
_WARNING_LINE = 18.0
_STATIC = "broken line: a static transform, which holds at every time and has no rate"


class FramesPicture(TreePicture):
    """What `rosrun tf2_tools view_frames.py` finds out, at one moment; it does not change later.

    Args:
        buffer: The transforms.
        now: Current time, shown as the time of recording; left out if None.

    Source:
        tf2_tools `view_frames.py`: the same facts on each edge. The layout is our own.
    """

    def __init__(self, buffer: Buffer, *, now: Time | None = None) -> None:
        self._forest: Forest = forest_of(buffer.core)
        self._yaml = buffer.all_frames_as_yaml()
        self._now = now

    @property
    def warnings(self) -> tuple[str, ...]:
        """Sentences on trees that are not connected, and on loops."""
        return self._forest.warnings

    def to_dot(self) -> str:
        """The tree in graphviz' language, as `frames.gv` has it."""
        return dot_text(self._forest, self._now)

    def to_yaml(self) -> str:
        """Parent, broadcaster, rate and stamps of each frame, as tf2 writes them."""
        return self._yaml

    def formats(self) -> Formats:
        """`.svg`, `.pdf`, `.png`, `.gv` and `.yaml`."""
        return {**super().formats(), ".yaml": self.to_yaml}

    def __repr__(self) -> str:
        return f"FramesPicture({self._forest.frame_count} frames, {len(self._forest.trees)} trees)"

    def drawing(self) -> Drawing:
        """The trees."""
        return _draw_forest(self._forest, self._now)


def _draw_forest(forest: Forest, now: Time | None) -> Drawing:
    """The page for some trees.

    Args:
        forest: The trees.
        now: Time of recording; left out if None.
    """
    layouts = _layouts(forest)
    has_static = any(node.is_static for tree in forest.trees for node in tree.nodes)
    key_width = text_width(_STATIC, SMALL) + 60 if has_static else 0.0
    width = max(_row_width(layouts), _LEAST_WIDTH, key_width) + 2 * MARGIN
    shapes: list[Shape] = list(_heading(forest, now))
    top = 18.0 * len(shapes) + 26
    for warning in forest.warnings:
        banner = _banner(warning, top, width - 2 * MARGIN)
        shapes += banner
        top += _WARNING_LINE * (len(banner) - 1) + 24
    bottom = top + max((layout.size[1] for layout in layouts), default=0.0)
    left = (width - _row_width(layouts)) / 2
    for layout in layouts:
        if len(layouts) > 1:
            shapes.append(_panel((left, top), (layout.size[0], bottom - top)))
        shapes += tree_shapes(layout, (left, top))
        left += layout.size[0] + _GAP
    if has_static:
        shapes += key_of_broken_lines((MARGIN, bottom + 22), _STATIC)
        bottom += 24
    return Drawing(
        title="Frames of tf",
        description=_description(forest),
        size=(round(width), round(bottom + MARGIN)),
        background=PAPER,
        shapes=tuple(shapes),
    )


def _layouts(forest: Forest) -> list[TreeLayout]:
    trees = [_card_nodes(tree) for tree in forest.trees]
    down = [tree_layout(nodes, is_sideways=False) for nodes in trees]
    if _row_width(down) <= READABLE_WIDTH:
        return down
    sideways = [tree_layout(nodes, is_sideways=True) for nodes in trees]
    return min(down, sideways, key=_row_width)


def _card_nodes(tree: FrameTree) -> list[CardNode]:
    return [
        CardNode(
            name=node.name,
            parent=node.parent,
            facts=() if node.report is None else _edge_facts(node.report),
            is_dashed=node.is_static,
            is_echo=node.is_echo,
        )
        for node in tree.nodes
    ]


def _row_width(layouts: Sequence[TreeLayout]) -> float:
    return sum(layout.size[0] for layout in layouts) + _GAP * max(len(layouts) - 1, 0)


def _heading(forest: Forest, now: Time | None) -> list[Label]:
    frames, trees = forest.frame_count, len(forest.trees)
    lines = [] if now is None else [f"Recorded at time: {_seconds(now)}"]
    lines.append(
        f"{frames} frame{'s' * (frames != 1)} in {trees} tree{'s' * (trees != 1)}"
        if trees
        else "No tf data received"
    )
    title = Label(place=(MARGIN, 30), text="view_frames Result", color=INK, size=15, bold=True)
    return [title] + [
        Label(place=(MARGIN, 50 + 18 * row), text=text, color=GREY, size=SMALL)
        for row, text in enumerate(lines)
    ]


def _banner(text: str, top: float, width: float) -> list[Shape]:
    words = " ".join(abbreviated(word, LONGEST + 4) for word in text.split())
    lines = wrapped(words, size=SMALL, width=width - 28)
    size = (width, _WARNING_LINE * len(lines) + 14)
    box = RoundedBox(corner=(MARGIN, top), size=size, fill=_WARNING, edge=_WARNING_EDGE, radius=6)
    rows = [
        Label(
            place=(MARGIN + 14, top + 20 + _WARNING_LINE * row),
            text=line,
            color=_WARNING_INK,
            size=SMALL,
        )
        for row, line in enumerate(lines)
    ]
    return [box, *rows]


def _panel(corner: Point, size: Point) -> RoundedBox:
    return RoundedBox(corner=corner, size=size, fill=_PANEL, edge=_PANEL_EDGE, radius=8)


def _description(forest: Forest) -> str:
    lines = [
        f"{node.report.name} in {node.report.parent}."
        for tree in forest.trees
        for node in tree.nodes
        if node.report is not None
    ]
    return " ".join([*forest.warnings, *lines]) or "No tf data received."


def dot_text(forest: Forest, now: Time | None) -> str:
    r"""The trees as a digraph; the `\n` in the labels are graphviz' own.

    Args:
        forest: The trees.
        now: Time of recording; without it there is no legend.

    Source:
        tf2_tools `view_frames.py`; it points its legend at one root only, and quotes nothing.
    """
    if not forest.trees:
        return 'digraph G { "No tf data received" }'
    reports = [node.report for tree in forest.trees for node in tree.nodes if node.report]
    lines = ["digraph G {", *(_edge(report) for report in reports)]
    if now is not None:
        roots = [dot_quoted(tree.nodes[0].name) for tree in forest.trees]
        target = roots[0] if len(roots) == 1 else "{" + "; ".join(roots) + "}"
        lines += [
            "edge [style=invis];",
            ' subgraph cluster_legend { style=bold; color=black; label ="view_frames Result";',
            f'"Recorded at time: {_seconds(now)}"[ shape=plaintext ] ;',
            f" }}->{target};",
        ]
    return "\n".join([*lines, "}"])


def _seconds(time: Time) -> str:
    """A time in seconds with three decimals."""
    return f"{time.to_sec():.3f}"


def _edge_facts(report: FrameReport) -> tuple[tuple[str, str], ...]:
    """The facts of an edge with their names, in the order of tf2_tools."""
    return (
        ("Broadcaster", report.broadcaster),
        ("Average rate", f"{report.rate:.3f}"),
        ("Buffer length", f"{report.length:.3f}"),
        ("Most recent transform", f"{report.newest:.3f}"),
        ("Oldest transform", f"{report.oldest:.3f}"),
    )


def _edge(report: FrameReport) -> str:
    facts = "".join(f"{name}: {dot_escaped(value)}\\n" for name, value in _edge_facts(report))
    return f'{dot_quoted(report.parent)} -> {dot_quoted(report.name)}[label=" {facts}"];'
