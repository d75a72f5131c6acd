"""The page of view_frames: heading, warnings, and the trees side by side."""

from __future__ import annotations

from collections.abc import Sequence

from simkit.msgs import Time
from simkit.viz.draw.drawing import Box, Drawing, Line, Point, Shape, Text
from simkit.viz.draw.letters import shortened, text_width, wrapped
from simkit.viz.forest import Forest, Tree
from simkit.viz.frames_dot import edge_facts, seconds
from simkit.viz.tree_drawing import GREY, INK, PAPER, tree_shapes
from simkit.viz.tree_layout import LONGEST, CardNode, TreeLayout, tree_layout

_MARGIN, _GAP = 18.0, 20.0
_LEAST_WIDTH = 420.0
_READABLE_WIDTH = 1000.0
"Up to this width a page of a notebook shows trees that grow downwards."
_PANEL, _PANEL_EDGE = "#f7f9fc", "#d9e1ea"
_WARNING, _WARNING_EDGE, _WARNING_INK = "#fff6e0", "#e4b343", "#6b4700"
_SMALL, _WARNING_LINE = 12.5, 18.0
_STATIC = "broken line: a static transform, which holds at every time and has no rate"


def draw_forest(forest: Forest, now: Time | None) -> Drawing:
    """The page for some trees.

    Args:
        forest: The trees.
        now: Time of recording; left out if None.
    """
    layouts = _layouts(forest)
    has_static = any(node.is_static for tree in forest.trees for node in tree.nodes)
    key_width = text_width(_STATIC, _SMALL) + 60 if has_static else 0.0
    width = max(_row_width(layouts), _LEAST_WIDTH, key_width) + 2 * _MARGIN
    shapes: list[Shape] = list(_heading(forest, now))
    top = 18.0 * len(shapes) + 26
    for warning in forest.warnings:
        banner = _banner(warning, top, width - 2 * _MARGIN)
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
        shapes += _key_of_static((_MARGIN, bottom + 22))
        bottom += 24
    return Drawing(
        title="Frames of tf",
        description=_description(forest),
        size=(round(width), round(bottom + _MARGIN)),
        background=PAPER,
        shapes=tuple(shapes),
    )


def _layouts(forest: Forest) -> list[TreeLayout]:
    trees = [_card_nodes(tree) for tree in forest.trees]
    down = [tree_layout(nodes, is_sideways=False) for nodes in trees]
    if _row_width(down) <= _READABLE_WIDTH:
        return down
    sideways = [tree_layout(nodes, is_sideways=True) for nodes in trees]
    return min(down, sideways, key=_row_width)


def _card_nodes(tree: Tree) -> list[CardNode]:
    return [
        CardNode(
            name=node.name,
            parent=node.parent,
            facts=() if node.report is None else edge_facts(node.report),
            is_dashed=node.is_static,
            is_echo=node.is_echo,
        )
        for node in tree.nodes
    ]


def _row_width(layouts: Sequence[TreeLayout]) -> float:
    return sum(layout.size[0] for layout in layouts) + _GAP * max(len(layouts) - 1, 0)


def _heading(forest: Forest, now: Time | None) -> list[Text]:
    frames, trees = forest.frame_count, len(forest.trees)
    lines = [] if now is None else [f"Recorded at time: {seconds(now)}"]
    lines.append(
        f"{frames} frame{'s' * (frames != 1)} in {trees} tree{'s' * (trees != 1)}"
        if trees
        else "No tf data received"
    )
    title = Text(place=(_MARGIN, 30), text="view_frames Result", color=INK, size=15, bold=True)
    return [title] + [
        Text(place=(_MARGIN, 50 + 18 * row), text=text, color=GREY, size=_SMALL)
        for row, text in enumerate(lines)
    ]


def _banner(text: str, top: float, width: float) -> list[Shape]:
    words = " ".join(shortened(word, LONGEST + 4) for word in text.split())
    lines = wrapped(words, size=_SMALL, width=width - 28)
    size = (width, _WARNING_LINE * len(lines) + 14)
    box = Box(corner=(_MARGIN, top), size=size, fill=_WARNING, edge=_WARNING_EDGE, radius=6)
    rows = [
        Text(
            place=(_MARGIN + 14, top + 20 + _WARNING_LINE * row),
            text=line,
            color=_WARNING_INK,
            size=_SMALL,
        )
        for row, line in enumerate(lines)
    ]
    return [box, *rows]


def _panel(corner: Point, size: Point) -> Box:
    return Box(corner=corner, size=size, fill=_PANEL, edge=_PANEL_EDGE, radius=8)


def _key_of_static(place: Point) -> list[Shape]:
    x, y = place
    return [
        Line(points=((x, y - 4), (x + 32, y - 4)), color=GREY, width=1.6, dashed=True),
        Text(place=(x + 42, y), text=_STATIC, color=GREY, size=_SMALL - 1),
    ]


def _description(forest: Forest) -> str:
    lines = [
        f"{node.report.name} in {node.report.parent}."
        for tree in forest.trees
        for node in tree.nodes
        if node.report is not None
    ]
    return " ".join([*forest.warnings, *lines]) or "No tf data received."
