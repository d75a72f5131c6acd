"""The controls of a replay: play, a slider over virtual time, the time, the speed."""

from __future__ import annotations

_SPEEDS = ("0.25", "0.5", "1", "2", "4", "8")


def tape_controls(duration: float) -> list[str]:
    """Lines of HTML; at first the slider is at the end.

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
