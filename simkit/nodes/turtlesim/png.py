"""A scene as PNG bytes, drawn with matplotlib's Agg and none of pyplot's state.

Only `picture` imports this, and only when a PNG is asked for, since matplotlib loads slowly.
"""

from __future__ import annotations

import io
from functools import singledispatch

from matplotlib import patches
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patheffects import withStroke
from matplotlib.transforms import Affine2D, Transform

from simkit.nodes.turtlesim.shapes import Ellipse, Group, Polygon, Polyline, Scene, Shape, Text

DOTS_PER_INCH = 100
POINTS_PER_PIXEL = 72 / DOTS_PER_INCH


def png_bytes(scene: Scene, scale: float) -> bytes:
    """The scene as a PNG file.

    Args:
        scene: What to draw.
        scale: Pixels of the file per pixel of the scene.
    """
    inches = scene.side / DOTS_PER_INCH
    figure = Figure(figsize=(inches, inches), dpi=DOTS_PER_INCH * scale, facecolor=scene.background)
    axes = figure.add_axes((0.0, 0.0, 1.0, 1.0))
    axes.set_axis_off()
    axes.set_xlim(0, scene.side)
    axes.set_ylim(scene.side, 0)
    for order, shape in enumerate(scene.shapes):
        _draw(shape, axes, axes.transData, order)
    buffer = io.BytesIO()
    canvas = FigureCanvasAgg(figure)
    # Not savefig: that would follow the reader's own settings of matplotlib, e.g. crop the window.
    canvas.print_png(buffer, metadata={"Software": None, "Title": scene.title})  # type: ignore[no-untyped-call]
    return buffer.getvalue()


@singledispatch
def _draw(shape: Shape, axes: Axes, transform: Transform, order: float) -> None:
    raise NotImplementedError(f"no PNG for {type(shape).__name__}")


@_draw.register
def _(shape: Polyline, axes: Axes, transform: Transform, order: float) -> None:
    line = Line2D(
        [x for x, _ in shape.points],
        [y for _, y in shape.points],
        color=shape.color,
        linewidth=shape.width * POINTS_PER_PIXEL,
        solid_capstyle="round",
        solid_joinstyle="round",
        transform=transform,
        zorder=order,
    )
    axes.add_artist(line)


@_draw.register
def _(shape: Polygon, axes: Axes, transform: Transform, order: float) -> None:
    area = patches.Polygon(
        list(shape.points), closed=True, facecolor=shape.fill, transform=transform, zorder=order
    )
    axes.add_artist(area)


@_draw.register
def _(shape: Ellipse, axes: Axes, transform: Transform, order: float) -> None:
    area = patches.Ellipse(
        shape.center,
        2 * shape.radii[0],
        2 * shape.radii[1],
        angle=shape.angle,
        facecolor=shape.fill,
        transform=transform,
        zorder=order,
    )
    axes.add_artist(area)


@_draw.register
def _(shape: Text, axes: Axes, transform: Transform, order: float) -> None:
    x, y = shape.center
    axes.text(
        x,
        y,
        shape.text,
        family="DejaVu Sans",
        fontsize=shape.size * POINTS_PER_PIXEL,
        color=shape.color,
        horizontalalignment="center",
        verticalalignment="baseline",
        path_effects=[withStroke(linewidth=3 * POINTS_PER_PIXEL, foreground=shape.halo)],
        parse_math=False,
        transform=transform,
        zorder=order,
    )


@_draw.register
def _(shape: Group, axes: Axes, transform: Transform, order: float) -> None:
    placed = Affine2D().rotate_deg(shape.angle).translate(*shape.origin)
    for index, part in enumerate(shape.shapes):
        _draw(part, axes, placed + transform, order + index / (len(shape.shapes) + 1))
