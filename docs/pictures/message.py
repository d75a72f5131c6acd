"""Drawing: the life of a message, from `publish` in one script to the callback of another."""

from __future__ import annotations

from collections.abc import Sequence

from drawing import BLUE, CARD, INK, MUTED, PLAIN, VIOLET, Area, Drawing, Point

QUEUE = (
    ("16.000", "813", "deliver to /logger", True),
    ("16.000", "814", "deliver to /follower", True),
    ("16.016", "806", "timer of /turtlesim", False),
    ("16.100", "815", "wake /talker", False),
)


def draw() -> str:
    """The drawing as SVG."""
    drawing = Drawing(
        "The life of a message",
        "A script publishes; the message becomes wire bytes and leaves in a frame when the script "
        "blocks. The graph checks it and makes one event for each subscription. A built-in node "
        "gets a decoded copy; a script gets the bytes in the frame that resumes it.",
        size=(1000, 490),
    )
    drawing.words((24, 36), "One message, from script to script", size=15, bold=True)
    drawing.words((976, 36), "Bytes travel; objects never do.", color=MUTED, anchor="end")
    _publisher(drawing)
    _graph(drawing)
    _subscriber(drawing)
    _frames(drawing)
    return drawing.svg()


def _publisher(drawing: Drawing) -> None:
    drawing.region(Area(24, 56, 204, 410), "process of /talker", color=VIOLET)
    _note(
        drawing, (40, 112), 1, "publish(msg)", ["each field is checked", "here, where its fault is"]
    )
    _note(drawing, (40, 202), 2, "wire bytes", ["in the format of ROS 1,", "put in an outbox"])
    _note(
        drawing,
        (40, 292),
        3,
        "rate.sleep()",
        ["the script blocks; what", "it said at this instant", "leaves as one frame"],
    )


def _graph(drawing: Drawing) -> None:
    drawing.region(Area(368, 56, 304, 410), "process of the simulation", color=BLUE)
    _note(drawing, (384, 112), 4, "is it well formed?", ["nothing else may travel on"])
    _note(
        drawing,
        (384, 170),
        5,
        "one event for each subscriber",
        ["in the order of (time, number)"],
    )
    for number, (time, sequence, what, is_ours) in enumerate(QUEUE):
        y = 202 + 27 * number
        drawing.bar(Area(420, y, 234, 23), color=BLUE if is_ours else PLAIN._replace(fill=CARD))
        ink = INK if is_ours else MUTED
        drawing.words((430, y + 16), time, size=11.5, color=ink, code=True)
        drawing.words((488, y + 16), sequence, size=11.5, color=ink, code=True)
        drawing.words((524, y + 16), what, size=11.5, color=ink)
    _note(
        drawing,
        (384, 344),
        6,
        "to a built-in node:",
        ["a copy of its own, decoded", "from the bytes"],
    )
    _note(drawing, (384, 424), 7, "to a script:", ["the bytes, and a turn"])


def _subscriber(drawing: Drawing) -> None:
    drawing.region(Area(800, 56, 176, 410), "process of /follower", color=VIOLET)
    _note(
        drawing,
        (816, 202),
        8,
        "callback(msg)",
        ["in its rospy.spin(),", "with a copy that is", "decoded here"],
    )
    _note(drawing, (816, 310), 9, "it blocks again", ["and virtual time", "goes on"])


def _frames(drawing: Drawing) -> None:
    _frame(drawing, (242, 266), ["PUBLISH bytes", "WAIT 16.100"])
    drawing.arrow([(190, 288), (240, 288)])
    drawing.words((298, 330), "one frame", size=12, color=MUTED, anchor="middle")
    drawing.arrow([(298, 264), (298, 108), (382, 108)])
    _frame(drawing, (680, 266), ["DELIVER bytes", "RESUME 16.000"])
    drawing.arrow([(512, 420), (736, 420), (736, 314)])
    drawing.arrow([(736, 264), (736, 198), (814, 198)])


def _frame(drawing: Drawing, place: Point, records: Sequence[str]) -> None:
    """A frame of the protocol on its way; `place` is its upper left corner."""
    x, y = place
    for number, record in enumerate(records):
        drawing.bar(Area(x, y + 23 * number, 112, 23), color=VIOLET)
        drawing.words((x + 56, y + 23 * number + 16), record, size=11, code=True, anchor="middle")


def _note(drawing: Drawing, place: Point, number: int, title: str, lines: Sequence[str]) -> None:
    """A numbered step with its title and lines."""
    x, y = place
    drawing.step((x + 12, y - 4), number)
    drawing.words((x + 34, y), title, bold=True)
    for count, line in enumerate(lines, 1):
        drawing.words((x + 34, y + 18 * count), line, size=12, color=MUTED)
