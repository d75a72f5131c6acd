"""A drawing as PNG or PDF, drawn by matplotlib.

Imported only when one of these is asked for, since matplotlib loads slowly.
"""

from __future__ import annotations

from functools import singledispatch

import numpy as np
from matplotlib import patches
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.path import Path
from matplotlib.patheffects import withStroke
from numpy.typing import NDArray

from simkit.viz.drawing import Area, Box, Curve, Drawing, Group, Line, Shape, Text
from simkit.viz.plain_matplotlib import pdf_of, plain_settings, png_of

_DOTS_PER_INCH = 100
_POINTS_PER_PIXEL = 72 / _DOTS_PER_INCH
_DASHES = (0.0, (5.0, 4.0))
_ALIGNMENT = {"start": "left", "middle": "center", "end": "right"}


def png_bytes(
    drawing: Drawing, *, scale: float = 2.0, pixels: NDArray[np.uint8] | None = None
) -> bytes:
    """The drawing as a PNG file.

    Args:
        drawing: What to draw.
        scale: Pixels of the file per pixel of the drawing.
        pixels: A picture to lay under all shapes, its upper left corner in that of the drawing; red, green, blue, opacity of
            each pixel of the file, shape (height, width, 4).
    """
    with plain_settings():
        figure = _figure(drawing, scale)
        if pixels is not None:
            below = round(drawing.size[1] * scale) - len(pixels)
            figure.figimage(pixels, 0, below, origin="upper", zorder=-1)
        return png_of(figure, title=drawing.title)


def pdf_bytes(drawing: Drawing) -> bytes:
    """The drawing as a PDF file of one page, as large as the drawing."""
    with plain_settings():
        return pdf_of(_figure(drawing, 1.0), title=drawing.title)


def _figure(drawing: Drawing, scale: float) -> Figure:
    width, height = drawing.size
    figure = Figure(
        figsize=(width / _DOTS_PER_INCH, height / _DOTS_PER_INCH),
        dpi=_DOTS_PER_INCH * scale,
        facecolor=drawing.background,
    )
    axes = figure.add_axes((0.0, 0.0, 1.0, 1.0))
    axes.set_axis_off()
    axes.set_xlim(0, width)
    axes.set_ylim(height, 0)
    for order, shape in enumerate(drawing.shapes):
        _draw(shape, axes, order)
    return figure


@singledispatch
def _draw(shape: Shape, axes: Axes, order: float) -> None:
    raise NotImplementedError(f"no picture for {type(shape).__name__}")


@_draw.register
def _(shape: Line, axes: Axes, order: float) -> None:
    line = Line2D(
        [x for x, _ in shape.points],
        [y for _, y in shape.points],
        color=shape.color,
        linewidth=shape.width * _POINTS_PER_PIXEL,
        linestyle=_DASHES if shape.dashed else "-",
        solid_capstyle="round",
        solid_joinstyle="round",
        zorder=order,
    )
    axes.add_artist(line)


@_draw.register
def _(shape: Curve, axes: Axes, order: float) -> None:
    path = Path(list(shape.points), [Path.MOVETO, Path.CURVE4, Path.CURVE4, Path.CURVE4])
    curve = patches.PathPatch(
        path,
        facecolor="none",
        edgecolor=shape.color,
        linewidth=shape.width * _POINTS_PER_PIXEL,
        linestyle=_DASHES if shape.dashed else "-",
        zorder=order,
    )
    axes.add_artist(curve)


@_draw.register
def _(shape: Area, axes: Axes, order: float) -> None:
    area = patches.Polygon(list(shape.points), closed=True, facecolor=shape.fill, zorder=order)
    axes.add_artist(area)


@_draw.register
def _(shape: Box, axes: Axes, order: float) -> None:
    box = patches.FancyBboxPatch(
        shape.corner,
        *shape.size,
        boxstyle=f"round,pad=0,rounding_size={shape.radius}",
        facecolor=shape.fill or "none",
        edgecolor=shape.edge or "none",
        linewidth=_POINTS_PER_PIXEL,
        linestyle=_DASHES if shape.dashed else "-",
        zorder=order,
    )
    axes.add_artist(box)


@_draw.register
def _(shape: Text, axes: Axes, order: float) -> None:
    halo = [withStroke(linewidth=3 * _POINTS_PER_PIXEL, foreground=shape.halo)]
    axes.text(
        *shape.place,
        shape.text,
        family="DejaVu Sans",
        fontsize=shape.size * _POINTS_PER_PIXEL,
        fontweight="bold" if shape.bold else "normal",
        color=shape.color,
        horizontalalignment=_ALIGNMENT[shape.align],
        verticalalignment="baseline",
        path_effects=halo if shape.halo else None,
        parse_math=False,
        zorder=order,
    )


@_draw.register
def _(shape: Group, axes: Axes, order: float) -> None:
    for index, part in enumerate(shape.shapes):
        _draw(part, axes, order + index / (len(shape.shapes) + 1))
