"""The way between two frames of a tree: up from the source, down to the target.

A way that was asked for is kept until the shape of the tree changes, with each run of static links
folded into one. Where it has no answer, the tree is climbed link by link, which finds the reason.
"""

from __future__ import annotations

from itertools import groupby
from typing import Final, NamedTuple

from simkit.geometry import Quaternion, Transform, Vector
from simkit.tf.cache import LATEST, StaticCache, TimeCache, carried
from simkit.tf.errors import DataGap, ExtrapolationException, TransformException
from simkit.tf.frame_tree import (
    MAX_DEPTH,
    NEVER,
    Cache,
    Climb,
    FrameTable,
    climb,
    latest_common_time,
    unconnected,
)

_KEPT: Final = 4096
"So many ways are kept; a program that asks for ever more of them starts anew."


class Path:
    """A way whose shape does not depend on the time.

    Args:
        up: The links from the source to the top, the lowest first.
        down: The links from the target to the top.
        shared: How many links at the end of both are the same: data is due there, but it does not
            decide what is the latest common time.
    """

    __slots__ = ("_answer", "_asked", "_down", "_timed", "_up")

    def __init__(self, up: list[Cache], down: list[Cache], *, shared: int) -> None:
        self._up, self._down = _folded(up), _folded(down)
        between = up[: len(up) - shared] + down[: len(down) - shared]
        self._timed = [cache for cache in between if isinstance(cache, TimeCache)]
        self._asked: tuple[int, int] | None = None
        self._answer: StampedTransform | None = None

    def at(self, time: int, *, changes: int) -> StampedTransform | None:
        """T_ab at `time` [ns] or the latest common time; None if a link has no data then.

        Args:
            time: When [ns].
            changes: Number of transforms that the table has taken in; the same question while
                nothing was added has the same answer.
        """
        if self._asked != (time, changes):
            self._answer = self._computed(self._latest() if time == LATEST else time)
            self._asked = (time, changes)
        return self._answer

    def _latest(self) -> int:
        common = min([cache.newest or NEVER for cache in self._timed], default=NEVER)
        return LATEST if common == NEVER else common

    def _computed(self, time: int) -> StampedTransform | None:
        up, down = carried(self._up, time), carried(self._down, time)
        if up is None or down is None:
            return None
        return StampedTransform(down.inverse() @ up if self._down else up, time)


def _folded(links: list[Cache]) -> list[Cache]:
    """The links with each run of static ones as one link."""
    folded: list[Cache] = []
    for is_static, run in groupby(links, lambda link: isinstance(link, StaticCache)):
        steps = list(run)
        product = carried(steps, LATEST) if is_static else None
        folded += [StaticCache((steps[-1].parent, *product))] if product else steps
    return folded


def _find(table: FrameTable, target: int, source: int) -> Path | None:
    """The way between two frames, if it is the same at all times."""
    up = _line(table, source, target)
    down = _line(table, target, source)
    if up and up[-1][0] == target:
        return Path([cache for _, cache in up], [], shared=0)
    if down and down[-1][0] == source:
        return Path([], [cache for _, cache in down], shared=0)
    if not up or not down or up[-1][0] != down[-1][0]:
        return None
    shared = 0
    while shared < min(len(up), len(down)) and up[-1 - shared][1] is down[-1 - shared][1]:
        shared += 1
    return Path([cache for _, cache in up], [cache for _, cache in down], shared=shared)


def _line(table: FrameTable, frame: int, goal: int) -> list[tuple[int, Cache]]:
    """Parent and link of a frame, its parent, ... up to the goal or the root; empty if it varies."""
    line: list[tuple[int, Cache]] = []
    while (cache := table.caches[frame]) is not None and frame != goal:
        frame = cache.parent
        if not frame or len(line) == MAX_DEPTH:
            return []
        line.append((frame, cache))
    return line


def transform_between(
    table: FrameTable, target: int, source: int, *, time: int
) -> StampedTransform:
    """T_ab for a = `target` and b = `source`, both by number, at `time` [ns].

    Raises:
        ConnectivityException: No way joins the frames.
        ExtrapolationException: A frame on the way lacks data at that time.
        LookupException: The tree has a loop on the way.
    """
    key = (target, source)
    if key not in table.paths:
        if len(table.paths) >= _KEPT:
            table.paths.clear()
        table.paths[key] = _find(table, target, source) if target != source else None
    path = table.paths[key]
    found = path.at(time, changes=table.changes) if path else None
    return climbed_between(table, target, source, time=time) if found is None else found


def climbed_between(table: FrameTable, target: int, source: int, *, time: int) -> StampedTransform:
    """`transform_between`, link by link.

    Raises:
        TransformException: As `transform_between`.

    Source:
        tf2 `BufferCore::walkToTopParent`: the source climbs as far as data reaches, then the
        target climbs until it meets it. So data above the place where they meet may be missing.
    """
    if target == source:
        return StampedTransform(Transform(), time)
    if time == LATEST:
        time = latest_common_time(table, target, source)
    up = climb(table, source, time=time, goals=(target, target))
    from_source = carried(up.links, time) or Transform()
    if up.top == target:
        return StampedTransform(from_source, time)
    down = climb(table, target, time=time, goals=(up.top, source))
    to_target = (carried(down.links, time) or Transform()).inverse()
    if down.top == source:
        return StampedTransform(to_target, time)
    if down.top != up.top:
        raise _no_way(table, target, source, time=time, climbs=(up, down))
    return StampedTransform(to_target @ from_source, time)


def frames_between(table: FrameTable, target: int, source: int, *, time: int) -> list[int]:
    """Numbers of the frames on the way, from the source to the target; empty if they are one.

    Raises:
        TransformException: As `transform_between`.
    """
    if target == source:
        return []
    time = transform_between(table, target, source, time=time).stamp
    up = _ancestors(table, source, time)
    down = _ancestors(table, target, time)
    on_the_way_up = set(up)
    meeting = next(frame for frame in down if frame in on_the_way_up)
    return up[: up.index(meeting) + 1] + down[: down.index(meeting)][::-1]


def _ancestors(table: FrameTable, frame: int, time: int) -> list[int]:
    """A frame, its parent, and so on, as far as data reaches; a loop is gone round once."""
    passed = [frame]
    while cache := table.caches[frame]:
        edge = cache.at(time)
        if edge is None or edge[0] in passed:
            break
        frame = edge[0]
        passed.append(frame)
    return passed


def _no_way(
    table: FrameTable, target: int, source: int, *, time: int, climbs: tuple[Climb, Climb]
) -> TransformException:
    """The error of tf for two climbs that do not meet: the target's lack of data comes first."""
    up, down = climbs
    lacking = down if down.lacks_data else up
    if not lacking.lacks_data:
        return unconnected(table, target, source)
    cache = table.caches[lacking.top]
    reason, gap = "", None
    if cache:
        reason = cache.refusal(time)
        oldest, newest = cache.span
        gap = DataGap(frame=table.names[lacking.top], requested=time, oldest=oldest, newest=newest)
    return ExtrapolationException(
        f"{reason}, when looking up transform from frame [{table.names[source]}] "
        f"to frame [{table.names[target]}]",
        gap=gap,
    )


class StampedTransform(NamedTuple):
    """T_ab at a time, for a = target and b = source; its quaternion is what was broadcast."""

    transform: Transform
    """T_ab; tf2 never normalises it."""
    stamp: int
    """Time it holds for [ns]."""

    @property
    def translation(self) -> Vector:
        """Origin of b seen from a [m]."""
        return self.transform.translation

    @property
    def rotation(self) -> Quaternion:
        """Orientation of b seen from a, xyzw."""
        return self.transform.rotation
