"""Follows the topics that displays show, as RViz does: each message waits until tf knows where it belongs.

Source: the message filter and the displays of RViz 1.14, with their words for what is wrong.
"""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Iterable
from typing import Any, Final

from simkit.errors import near_names
from simkit.geometry import Quaternion, Transform, Vector
from simkit.graph import Node
from simkit.msgs import Message, message_class
from simkit.tf import (
    Buffer,
    ConnectivityException,
    ExtrapolationException,
    TransformException,
)
from simkit.viz.stage.parts import Marks
from simkit.viz.stage.rviz_settings import LaserScanDisplay, OdometryDisplay, TopicDisplay, label
from simkit.viz.stage.topic_marks import (
    NOTHING,
    Shown,
    arrow_line,
    display_marks,
    path_shown,
    scan_shown,
)

QUEUE: Final = 10
"""So many messages wait for tf; of more, the oldest is forgotten."""
_COMPARED = 200
"So many names are searched for a near one."


class DisplayListener:
    """What one display knows.

    Args:
        display: What it shows.
        buffer: The transforms.
        fixed_frame: The frame that everything is drawn in.
    """

    def __init__(self, display: TopicDisplay, *, buffer: Buffer, fixed_frame: str) -> None:
        self._display = display
        self._core, self._fixed_frame = buffer.core, fixed_frame
        self._waiting: deque[Any] = deque(maxlen=QUEUE)
        self._shown = NOTHING
        self._newest: tuple[Any, Transform] | None = None
        self._last: tuple[Vector, Quaternion] | None = None
        self._is_drawn = False
        self._has_heard = False
        self._problem = ""

    @property
    def is_silent(self) -> bool:
        """Whether no message has come yet."""
        return not self._has_heard

    def hear(self, message: Any) -> None:
        """Take a message of the topic."""
        self._has_heard = True
        if isinstance(self._display, OdometryDisplay) and not self._is_step(message):
            return
        self._waiting.append(message)
        self._place()

    def look(self) -> Shown:
        """What is to be seen now; the same object until something has changed."""
        self._place()
        if self._newest is not None:
            message, place = self._newest
            self._newest, self._is_drawn = None, True
            if isinstance(self._display, LaserScanDisplay):
                self._shown = scan_shown(self._display, message, place)
            else:
                self._shown = path_shown(message, place)
        return self._shown

    def trouble(self) -> str:
        """A sentence on what cannot be shown; empty if nothing is wrong."""
        self._place()
        return self._problem if self._has_heard else f"{label(self._display)}: {_SILENCE}"

    def _is_step(self, odometry: Any) -> bool:
        """Whether a pose is far enough from the last one that was taken."""
        position, turn = odometry.pose.pose.position, odometry.pose.pose.orientation
        pose = (position.x, position.y, position.z), (turn.x, turn.y, turn.z, turn.w)
        length = math.hypot(*pose[1])
        if not (all(map(math.isfinite, pose[0])) and 0.0 < length < math.inf):
            self._problem = f"{label(self._display)}: {_NO_NUMBERS}"
            return False
        if self._last is not None and self._is_near(self._last, pose):
            return False
        self._last = pose
        return True

    def _is_near(self, last: tuple[Vector, Quaternion], pose: tuple[Vector, Quaternion]) -> bool:
        display = self._display
        assert isinstance(display, OdometryDisplay)
        is_near = math.dist(last[0], pose[0]) < display.position_tolerance
        return is_near and _angle(last[1], pose[1]) < display.angle_tolerance

    def _place(self) -> None:
        """Put everything in its place for which tf has the time by now, in the order of arrival."""
        while self._waiting:
            message = self._waiting[0]
            try:
                place = self._lookup(message.header)
            except TransformException as error:
                # A message that is newer than tf is nothing to worry about: tf mostly comes a moment later.
                is_usual = isinstance(error, ExtrapolationException) and self._shows_something
                if not is_usual or len(self._waiting) == QUEUE:
                    self._problem = self._missing(message.header.frame_id, error)
                return
            self._waiting.popleft()
            self._problem = ""
            self._take(message, place)

    @property
    def _shows_something(self) -> bool:
        return self._newest is not None or self._is_drawn

    def _take(self, message: Any, place: Transform) -> None:
        if not isinstance(self._display, OdometryDisplay):
            self._newest = (message, place)
            return
        self._is_drawn = True
        line = arrow_line(self._display, *_pose(message.pose.pose, place))
        kept = (*self._shown.lines, line)[-self._display.keep :]
        self._shown = Shown(lines=kept, count=self._shown.count + 1)

    def _lookup(self, header: Any) -> Transform:
        frame = header.frame_id.lstrip("/")
        if frame == self._fixed_frame:  # is no question, also if nobody ever broadcast it
            return Transform()
        return self._core.lookup(self._fixed_frame, frame, time=header.stamp.to_nsec()).transform

    def _missing(self, frame: str, error: TransformException) -> str:
        frame = frame.lstrip("/")
        start = f"{label(self._display)}: No transform from [{frame}] to [{self._fixed_frame}]"
        return f"{start}: {self._reason(frame, error)}"

    def _reason(self, frame: str, error: TransformException) -> str:
        for name, words in ((self._fixed_frame, "Fixed Frame"), (frame, "Frame")):
            if not self._core.frame_exists(name):
                known = self._core.frame_strings[:_COMPARED]
                near = " or ".join(f"[{other}]" for other in near_names(name, known))
                question = f" Did you mean {near}?" if near else ""
                return f"{words} [{name}] does not exist.{question}"
        if isinstance(error, ConnectivityException):
            return "they are in two trees."
        return "tf has no data for the time of the message."


_SILENCE: Final = "No messages received."
_NO_NUMBERS: Final = (
    "Message contained invalid floating point values (nans or infs), or a quaternion of zeros."
)


def _pose(pose: Any, place: Transform) -> tuple[Vector, Quaternion]:
    """A pose of a message in the fixed frame."""
    p, q = pose.position, pose.orientation
    length = math.hypot(q.x, q.y, q.z, q.w)
    turn = (q.x / length, q.y / length, q.z / length, q.w / length)
    found = place @ Transform((p.x, p.y, p.z), turn)
    return found.translation, found.rotation


def _angle(a: Quaternion, b: Quaternion) -> float:
    """Angle between two turns [rad], of quaternions of any length."""
    dot = math.fsum(p * q for p, q in zip(a, b, strict=True))
    return 2.0 * math.acos(min(1.0, abs(dot) / (math.hypot(*a) * math.hypot(*b))))


class TopicListeners:
    """A listener for each display and fixed frame.

    Args:
        node: The node that listens.
        buffer: The transforms.
    """

    def __init__(self, node: Node, buffer: Buffer) -> None:
        self._node, self._buffer = node, buffer
        self._listeners: dict[tuple[TopicDisplay, str], DisplayListener] = {}

    def marks(self, displays: Iterable[TopicDisplay], fixed_frame: str) -> tuple[Marks, ...]:
        """What the displays draw now.

        Args:
            displays: What is shown.
            fixed_frame: The frame that everything is drawn in.
        """
        return tuple(
            display_marks(display, number, self._listener(display, fixed_frame).look())
            for number, display in enumerate(displays)
        )

    def troubles(self, displays: Iterable[TopicDisplay], fixed_frame: str) -> tuple[str, ...]:
        """A sentence for each display that has nothing to draw, or cannot draw it.

        Args:
            displays: What is shown.
            fixed_frame: The frame that everything is drawn in.
        """
        found = [(one.topic, self._listener(one, fixed_frame)) for one in displays]
        return tuple(
            f"{trouble}{self._why_silent(topic) if listener.is_silent else ''}"
            for topic, listener in found
            if (trouble := listener.trouble())
        )

    def _why_silent(self, topic: str) -> str:
        known = self._node.graph.topics.get(topic)
        if known is None or not known.publishers:
            return " Nobody publishes this topic."
        return " It is listened to from the first view of it on: sim.run(0.2), and look again."

    def _listener(self, display: TopicDisplay, fixed_frame: str) -> DisplayListener:
        listener = self._listeners.get((display, fixed_frame))
        if listener is None:
            listener = DisplayListener(display, buffer=self._buffer, fixed_frame=fixed_frame)
            self._listeners[display, fixed_frame] = listener
            self._listen(display, listener)
        return listener

    def _listen(self, display: TopicDisplay, listener: DisplayListener) -> None:
        cls: type[Message] = message_class(display.type_name)
        graph = self._node.graph
        known = graph.topics.get(display.topic)
        if known is not None and known.last and known.message_class._type == display.type_name:
            listener.hear(cls.from_bytes(known.last))
        graph.add_subscription(
            display.topic,
            cls,
            self._node.name,
            lambda data, _caller: listener.hear(cls.from_bytes(data)),
        )
