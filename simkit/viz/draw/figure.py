"""Pictures of matplotlib: a drawing as PNG or PDF, and any figure with the same bytes everywhere.

Imported only when one of these is asked for, since matplotlib loads slowly.
"""

from __future__ import annotations

import html
import io
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from functools import singledispatch
from typing import Any, Literal

import matplotlib
import numpy as np
from matplotlib import patches
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.backends.backend_pdf import FigureCanvasPdf
from matplotlib.backends.backend_svg import FigureCanvasSVG
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.path import Path
from matplotlib.patheffects import withStroke
from matplotlib.text import Text
from matplotlib.transforms import Affine2D, Transform
from numpy.typing import NDArray

from simkit.viz.draw.drawing import (
    Area,
    Curve,
    Drawing,
    Ellipse,
    Group,
    Label,
    Polyline,
    RoundedBox,
    Shape,
)

_NOT_OURS = frozenset({"backend", "backend_fallback", "interactive", "toolbar"})
_DOTS_PER_INCH = 100
_POINTS_PER_PIXEL = 72 / _DOTS_PER_INCH
_DASHES = (0.0, (5.0, 4.0))
_ALIGNMENT: dict[str, Literal["left", "center", "right"]] = {
    "start": "left",
    "middle": "center",
    "end": "right",
}


@contextmanager
def plain_settings() -> Iterator[None]:
    """The defaults of matplotlib while it lasts; figures are made and written inside."""
    settings: Any = {
        key: value for key, value in matplotlib.rcParamsDefault.items() if key not in _NOT_OURS
    }
    # The salt makes the names inside an SVG the same each time; its text stays text.
    settings |= {"svg.hashsalt": "simkit", "svg.fonttype": "none"}
    with matplotlib.rc_context(settings), warnings.catch_warnings():
        # A letter that the font lacks is drawn as a box; there is nothing to be done about it.
        warnings.filterwarnings("ignore", message="Glyph .* missing from font")
        yield


def png_of(figure: Figure, *, title: str) -> bytes:
    """The figure as a PNG file, in its own size."""
    buffer = io.BytesIO()
    canvas = FigureCanvasAgg(figure)
    # Not savefig: that would follow the reader's own settings, e.g. crop the page.
    canvas.print_png(buffer, metadata={"Software": None, "Title": title})  # type: ignore[no-untyped-call]
    return buffer.getvalue()


def pdf_of(figure: Figure, *, title: str) -> bytes:
    """The figure as a PDF file of one page."""
    buffer = io.BytesIO()
    nameless = {"CreationDate": None, "Creator": None, "Producer": None}
    canvas = FigureCanvasPdf(figure)
    canvas.print_pdf(buffer, metadata={**nameless, "Title": title})  # type: ignore[no-untyped-call]
    return buffer.getvalue()


def svg_of(figure: Figure, *, title: str) -> str:
    """The figure as an SVG document, with its title to be read out, without links to elsewhere."""
    buffer = io.StringIO()
    nameless = dict.fromkeys(("Creator", "Date", "Format", "Type"))
    FigureCanvasSVG(figure).print_svg(buffer, metadata=nameless)  # type: ignore[no-untyped-call]
    text = buffer.getvalue()
    head, rest = text[text.index("<svg") :].split(">", 1)
    return f'{head} role="img">\n <title>{html.escape(title)}</title>{rest}'


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
        _draw(shape, axes, axes.transData, order)
    return figure


def _draw(shape: Shape, axes: Axes, transform: Transform, order: float) -> None:
    if isinstance(shape, Group):
        placed = Affine2D().rotate_deg(shape.angle).translate(*(shape.origin or (0.0, 0.0)))
        for index, part in enumerate(shape.shapes):
            _draw(part, axes, placed + transform, order + index / (len(shape.shapes) + 1))
        return
    artist = _artist(shape)
    artist.set_zorder(order)
    artist.set_transform(transform)
    axes.add_artist(artist)


@singledispatch
def _artist(shape: Shape) -> Artist:
    raise NotImplementedError(f"no picture for {type(shape).__name__}")


@_artist.register
def _(shape: Polyline) -> Artist:
    return Line2D(
        [x for x, _ in shape.points],
        [y for _, y in shape.points],
        color=shape.color,
        linewidth=shape.width * _POINTS_PER_PIXEL,
        linestyle=_DASHES if shape.dashed else "-",
        solid_capstyle="round",
        solid_joinstyle="round",
    )


@_artist.register
def _(shape: Curve) -> Artist:
    path = Path(list(shape.points), [Path.MOVETO, Path.CURVE4, Path.CURVE4, Path.CURVE4])
    return patches.PathPatch(
        path,
        facecolor="none",
        edgecolor=shape.color,
        linewidth=shape.width * _POINTS_PER_PIXEL,
        linestyle=_DASHES if shape.dashed else "-",
    )


@_artist.register
def _(shape: Area) -> Artist:
    return patches.Polygon(list(shape.points), closed=True, facecolor=shape.fill)


@_artist.register
def _(shape: Ellipse) -> Artist:
    width, height = 2 * shape.radii[0], 2 * shape.radii[1]
    return patches.Ellipse(shape.center, width, height, angle=shape.angle, facecolor=shape.fill)


@_artist.register
def _(shape: RoundedBox) -> Artist:
    return patches.FancyBboxPatch(
        shape.corner,
        *shape.size,
        boxstyle=f"round,pad=0,rounding_size={shape.radius}",
        facecolor=shape.fill or "none",
        edgecolor=shape.edge or "none",
        linewidth=_POINTS_PER_PIXEL,
        linestyle=_DASHES if shape.dashed else "-",
    )


@_artist.register
def _(shape: Label) -> Artist:
    halo = [withStroke(linewidth=3 * _POINTS_PER_PIXEL, foreground=shape.halo)]
    return Text(
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
    )
