"""What a caller may give as a time, turned into nanoseconds."""

from __future__ import annotations

from simkit.msgs import Duration, Time


def nanoseconds(time: object) -> int:
    """Nanoseconds of a Time, a Duration, or anything that has `to_sec`.

    Raises:
        TypeError: It is a bare number or no time at all.
    """
    if isinstance(time, Time | Duration):
        return time.to_nsec()
    to_sec = getattr(time, "to_sec", None)
    if to_sec is not None:
        return round(float(to_sec()) * 1e9)
    error = TypeError("time must have a to_sec method, e.g. rospy.Time or rospy.Duration")
    error.add_note(
        f"You gave {time!r}, a {type(time).__name__}; for seconds write rospy.Time(...)."
    )
    raise error
