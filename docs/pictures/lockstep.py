"""Drawing: virtual time and lockstep, as a diagram of who acts when."""

from __future__ import annotations

from drawing import BLUE, GREEN, INK, MUTED, PLAIN, VIOLET, Area, Drawing

CLOCK, TURTLESIM, SCRIPT, BUFFER = 262.0, 450.0, 646.0, 842.0


def draw() -> str:
    """The drawing as SVG."""
    drawing = Drawing(
        "Virtual time and lockstep",
        "At each instant the executor runs the events that are due, one after the other: the timer "
        "of turtlesim, the delivery of its pose, a turn of the script, the delivery of its "
        "transform. Only then does the clock jump to the next event.",
        size=(960, 600),
    )
    drawing.words((30, 36), "One instant after the other, one node at a time", size=15, bold=True)
    _lanes(drawing)
    _instant(drawing, 126, "16.016")
    _pause(drawing, 330)
    _instant(drawing, 384, "16.032")
    return drawing.svg()


def _lanes(drawing: Drawing) -> None:
    heads = (
        (CLOCK, "executor", "owns the clock", BLUE),
        (TURTLESIM, "turtlesim", "object in this process", PLAIN),
        (SCRIPT, "broadcaster.py", "process of its own", VIOLET),
        (BUFFER, "TF buffer", "object in this process", PLAIN),
    )
    for x, title, line, color in heads:
        drawing.line([(x, 104), (x, 580)], color="#c3cad3", width=1.2)
        drawing.box(Area(x - 80, 56, 160, 50), title, lines=[line], color=color)
    drawing.words((30, 76), "virtual", size=12, color=MUTED)
    drawing.words((30, 92), "time [s]", size=12, color=MUTED)


def _instant(drawing: Drawing, top: float, time: str) -> None:
    """All that happens at one instant, in order."""
    drawing.bar(Area(24, top, 912, 200), color=BLUE._replace(fill="#4556ff0d", edge="#4556ff30"))
    drawing.words((36, top + 26), time, size=16, bold=True, color=BLUE.edge)
    drawing.words((36, top + 46), "the clock stands", size=12, color=MUTED)
    drawing.words((36, top + 62), "still", size=12, color=MUTED)
    _call(drawing, top + 26, (CLOCK, TURTLESIM), "timer")
    drawing.bar(Area(TURTLESIM - 6, top + 22, 12, 26), color=GREEN)
    _call(drawing, top + 48, (TURTLESIM, CLOCK), "pose: an event, now")
    _call(drawing, top + 82, (CLOCK, SCRIPT), "DELIVER pose, RESUME")
    drawing.bar(Area(SCRIPT - 6, top + 78, 12, 56), color=VIOLET)
    drawing.words((SCRIPT + 16, top + 100), "computes and publishes;", size=12, color=MUTED)
    drawing.words((SCRIPT + 16, top + 116), "all others wait for it", size=12, color=MUTED)
    _call(drawing, top + 134, (SCRIPT, CLOCK), "PUBLISH transform, WAIT")
    _call(drawing, top + 170, (CLOCK, BUFFER), "transform")
    drawing.bar(Area(BUFFER - 6, top + 166, 12, 22), color=GREEN)


def _call(drawing: Drawing, y: float, ends: tuple[float, float], text: str) -> None:
    """An arrow from lane to lane with its text above, near where it begins."""
    start, end = ends
    side = 8 if end > start else -8
    drawing.arrow([(start + side, y), (end - side, y)], color=INK)
    left = min(start, end)
    drawing.words((left + 14, y - 5), text, size=12)


def _pause(drawing: Drawing, top: float) -> None:
    """The jump of the clock from one instant to the next."""
    drawing.arrow([(CLOCK, top), (CLOCK, top + 50)], color=BLUE.edge)
    drawing.words((36, top + 24), "nothing more is due:", size=12, color=MUTED)
    drawing.words((36, top + 40), "the clock jumps to the next event", size=12, color=MUTED)
