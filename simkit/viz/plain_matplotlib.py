"""matplotlib without the reader's own settings, dates and versions: the same bytes everywhere."""

from __future__ import annotations

import html
import io
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import matplotlib
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.backends.backend_pdf import FigureCanvasPdf
from matplotlib.backends.backend_svg import FigureCanvasSVG
from matplotlib.figure import Figure

_NOT_OURS = frozenset({"backend", "backend_fallback", "interactive", "toolbar"})


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
