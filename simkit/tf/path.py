"""The way between two frames of a tree: up from the source, down to the target."""

from __future__ import annotations

from simkit.geometry import Transform
from simkit.tf.cache import LATEST
from simkit.tf.climb import Climb, climb
from simkit.tf.common_time import latest_common_time, unconnected
from simkit.tf.errors import DataGap, ExtrapolationException, TransformException
from simkit.tf.frame_table import FrameTable
from simkit.tf.transform import StampedTransform


def transform_between(
    table: FrameTable, target: int, source: int, *, time: int
) -> StampedTransform:
    """T_ab for a = `target` and b = `source`, both by number, at `time` [ns].

    Raises:
        ConnectivityException: No way joins the frames.
        ExtrapolationException: A frame on the way lacks data at that time.
        LookupException: The tree has a loop on the way.

    Source:
        tf2 `BufferCore::walkToTopParent`: the source climbs as far as data reaches, then the
        target climbs until it meets it. So data above the place where they meet may be missing.
    """
    if target == source:
        return StampedTransform(Transform(), time)
    if time == LATEST:
        time = latest_common_time(table, target, source)
    up = climb(table, source, time=time, goals=(target, target))
    from_source = Transform(up.translation, up.rotation)
    if up.top == target:
        return StampedTransform(from_source, time)
    down = climb(table, target, time=time, goals=(up.top, source))
    to_target = Transform(down.translation, down.rotation).inverse()
    if down.top == source:
        return StampedTransform(to_target, time)
    if down.top != up.top:
        raise _no_way(table, target, source, time=time, climbs=(up, down))
    return StampedTransform(to_target @ from_source, time)


def frames_between(table: FrameTable, target: int, source: int, *, time: int) -> list[int]:
    """Numbers of the frames on the way, from the source to the target; none if they are one.

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
    """What tf says when two climbs do not meet: the target's lack of data comes first."""
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
