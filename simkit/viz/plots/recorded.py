"""What plots need of a recording: the topics of a type, and the time of their messages."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any, Protocol

from simkit.errors import SimkitError, UnknownNameError
from simkit.msgs import Message, Time


class RecordedTopics(Protocol):
    """What `sim.record(["/tf"])` answers."""

    def topics(self) -> list[str]:
        """Names of the recorded topics."""
        ...

    def __getitem__(self, topic: str) -> Iterable[tuple[Time, Message]]:
        """Messages of a topic with their times."""
        ...


def recorded_topic(recording: RecordedTopics, type_name: str, topic: str | None) -> str:
    """The topic to plot.

    Args:
        recording: What was recorded.
        type_name: Type that its messages must have.
        topic: Its name, with or without the slash; the only one of that type if None.

    Raises:
        UnknownNameError: The topic was not recorded.
        SimkitError: It has no message, or messages of another type; or there is not just one of that type.
    """
    if topic is None:
        return _only(recording, type_name)
    name = f"/{topic.lstrip('/')}"
    if name not in recording.topics():
        raise UnknownNameError("recorded topic", name, recording.topics())
    found = _type_of(recording, name)
    if found is None:
        raise SimkitError(
            f"no message on {name} was recorded: record it before the simulation runs"
        )
    if found != type_name:
        raise SimkitError(f"{name} carries {found}, and this plot shows {type_name}")
    return name


def topics_of(recording: RecordedTopics, type_name: str) -> list[str]:
    """Recorded topics that have messages of a type, sorted."""
    return [name for name in recording.topics() if _type_of(recording, name) == type_name]


def timed(recording: RecordedTopics, topic: str) -> Iterator[tuple[int, Any]]:
    """Messages with the time of their header [ns], or if that is 0, that of their arrival."""
    for time, message in recording[topic]:
        stamp: Time = message.header.stamp
        yield (stamp.to_nsec() or time.to_nsec()), message


def _only(recording: RecordedTopics, type_name: str) -> str:
    found = topics_of(recording, type_name)
    if len(found) == 1:
        return found[0]
    if found:
        raise SimkitError(f"{', '.join(found)} were recorded: say which, e.g. topic={found[0]!r}")
    raise SimkitError(
        f"no message of {type_name} was recorded, but {', '.join(recording.topics()) or 'nothing'}: "
        "record its topic before the simulation runs"
    )


def _type_of(recording: RecordedTopics, name: str) -> str | None:
    return next((message._type for _, message in recording[name]), None)
