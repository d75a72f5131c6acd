"""A replay: a tape as one page, with a button to play, a slider over virtual time and a choice of speeds."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

from simkit.viz.draw.files import save_as
from simkit.viz.draw.thinning import Row
from simkit.viz.page.html import inline_frame, png_image

_SPEEDS: Final = ("0.25", "0.5", "1", "2", "4", "8")


@dataclass(frozen=True, slots=True, kw_only=True)
class Track:
    """The values of one thing over time."""

    rows: tuple[Row, ...]
    """Time [s] and the values; straight in between, and two rows of one time are a jump."""
    until: float | None = None
    """When the thing was gone [s]; None if it was there to the end."""


class Replay:
    """What was seen from a beginning to an end; it does not change afterwards.

    It needs neither a server nor a network: it also works in a file and in a saved notebook. Where frames are
    left out, and where scripts do not run, its end is seen.
    """

    TITLE: str
    """What is played, for screen readers."""

    def to_html(self) -> str:
        """The replay as one HTML file; equal recordings give equal text."""
        raise NotImplementedError

    def end_png(self) -> bytes:
        """The end as a PNG file."""
        raise NotImplementedError

    def height(self) -> int:
        """Room that the page needs inside another [px]; what is more is scrolled."""
        raise NotImplementedError

    def save(self, path: str | Path) -> None:
        """Write the replay to an `.html` file.

        Raises:
            UnknownNameError: The suffix is another one.
        """
        save_as(path, {".html": self.to_html}, kind="replay format")

    def _repr_html_(self) -> str:
        from simkit.viz.draw.files import few_colored_png

        still = png_image(few_colored_png(self.end_png()), f"{self.TITLE}: the end")
        return inline_frame(self.to_html(), title=self.TITLE, height=self.height(), still=still)

    def _repr_png_(self) -> bytes:
        return self.end_png()


def track_data(track: Track, *, digits: int) -> Mapping[str, Any]:
    """A track for the script of a replay.

    Args:
        track: The track.
        digits: Decimals of its values.
    """
    rows = [[round(row[0], 3), *(round(value, digits) for value in row[1:])] for row in track.rows]
    return {"until": track.until, "rows": rows}


def tape_controls(duration: float) -> list[str]:
    """Lines of HTML: a button to play, a slider over virtual time, the time, the speed; at first it is at the end.

    Args:
        duration: From the beginning to the end [s].
    """
    end = f"{duration:.3f}"
    options = "".join(
        f'<option value="{speed}"{" selected" if speed == "1" else ""}>{speed} ×</option>'
        for speed in _SPEEDS
    )
    return [
        '<div class="row">',
        '<button id="play">Play</button>',
        f'<input id="time" type="range" min="0" max="{end}" step="any" value="{end}" '
        'aria-label="Virtual time">',
        f'<output id="clock" for="time">{duration:.2f} s</output>',
        f'<label>Speed <select id="speed">{options}</select></label>',
        "</div>",
    ]
