"""Listens to the topics that displays show.

A display knows what was said since a view of it was first asked for, and the last message before
that; views of the same simulation share what they have heard.
"""

from __future__ import annotations

from collections.abc import Iterable

from simkit.graph import Node
from simkit.msgs import Message, message_class
from simkit.tf import Buffer
from simkit.viz.marks import Marks
from simkit.viz.topics.display_ear import DisplayEar
from simkit.viz.topics.displays import TopicDisplay
from simkit.viz.topics.topic_marks import display_marks


class RvizEars:
    """An ear for each display and fixed frame.

    Args:
        node: The node that listens.
        buffer: The transforms.
    """

    def __init__(self, node: Node, buffer: Buffer) -> None:
        self._node, self._buffer = node, buffer
        self._ears: dict[tuple[TopicDisplay, str], DisplayEar] = {}

    def marks(self, displays: Iterable[TopicDisplay], fixed_frame: str) -> tuple[Marks, ...]:
        """What the displays draw now.

        Args:
            displays: What is shown.
            fixed_frame: The frame that everything is drawn in.
        """
        return tuple(
            display_marks(display, number, self._ear(display, fixed_frame).look())
            for number, display in enumerate(displays)
        )

    def troubles(self, displays: Iterable[TopicDisplay], fixed_frame: str) -> tuple[str, ...]:
        """A sentence for each display that has nothing to draw, or cannot draw it.

        Args:
            displays: What is shown.
            fixed_frame: The frame that everything is drawn in.
        """
        found = [(one.topic, self._ear(one, fixed_frame)) for one in displays]
        return tuple(
            f"{trouble}{self._why_silent(topic) if ear.is_silent else ''}"
            for topic, ear in found
            if (trouble := ear.trouble())
        )

    def _why_silent(self, topic: str) -> str:
        known = self._node.graph.topics.get(topic)
        if known is None or not known.publishers:
            return " Nobody publishes this topic."
        return " It is listened to from the first view of it on: sim.run(0.2), and look again."

    def _ear(self, display: TopicDisplay, fixed_frame: str) -> DisplayEar:
        ear = self._ears.get((display, fixed_frame))
        if ear is None:
            ear = DisplayEar(display, buffer=self._buffer, fixed_frame=fixed_frame)
            self._ears[display, fixed_frame] = ear
            self._listen(display, ear)
        return ear

    def _listen(self, display: TopicDisplay, ear: DisplayEar) -> None:
        cls: type[Message] = message_class(display.type_name)
        graph = self._node.graph
        known = graph.topics.get(display.topic)
        if known is not None and known.last and known.message_class._type == display.type_name:
            ear.hear(cls.from_bytes(known.last))
        graph.add_subscription(
            display.topic,
            cls,
            self._node.name,
            lambda data, _caller: ear.hear(cls.from_bytes(data)),
        )
