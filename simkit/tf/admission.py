"""What a broadcast must fulfil: tf's objections to a transform, advice on its rotation, rival broadcasters."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Final

from simkit.geometry import Quaternion, Vector

NORM_TOLERANCE: Final = 0.01
"Largest accepted distance of |q|² from 1."


def without_slash(name: str) -> str:
    """The name without its leading slash; of two slashes, one stays, as in tf2."""
    return name.removeprefix("/")


def is_admissible(parent: str, child: str, *, translation: Vector, rotation: Quaternion) -> bool:
    """Whether there are no `objections`: the quick way for what is good, as nearly all is."""
    x, y, z, w = rotation
    norm = x * x + y * y + z * z + w * w
    # Comparisons with nan are false; a sum is nan if a part of it is, or for infinities of both signs.
    return (
        child != parent
        and child != ""
        and parent != ""
        and abs(norm - 1.0) < NORM_TOLERANCE
        and (place := sum(translation)) == place
    )


def objections(
    parent: str, child: str, *, translation: Vector, rotation: Quaternion, authority: str
) -> Iterator[str]:
    """Everything that is wrong with a transform, one sentence each; nothing if it is good.

    Args:
        parent: Frame that the transform is expressed in, without leading slash.
        child: Frame that is placed, without leading slash.
        translation: Origin of `child` in `parent` [m].
        rotation: Orientation of `child` in `parent`, xyzw.
        authority: Name of the node that broadcast it.

    Source:
        tf2 `BufferCore::setTransform`: all checks run, in this order.
    """
    if child == parent:
        yield (
            f'TF_SELF_TRANSFORM: Ignoring transform from authority "{authority}" with frame_id '
            f'and child_frame_id  "{child}" because they are the same'
        )
    if not child:
        yield (
            f'TF_NO_CHILD_FRAME_ID: Ignoring transform from authority "{authority}" '
            "because child_frame_id not set "
        )
    if not parent:
        yield (
            f'TF_NO_FRAME_ID: Ignoring transform with child_frame_id "{child}"  '
            f'from authority "{authority}" because frame_id not set'
        )
    ignoring = f'Ignoring transform for child_frame_id "{child}" from authority "{authority}"'
    if any(map(math.isnan, (*translation, *rotation))):
        yield (
            f"TF_NAN_INPUT: {ignoring} because of a nan value in the transform "
            f"{_numbers(translation)} {_numbers(rotation)}"
        )
    # Written so that a norm of nan is refused too.
    if not abs(sum(c * c for c in rotation) - 1.0) < NORM_TOLERANCE:
        yield (
            f"TF_DENORMALIZED_QUATERNION: {ignoring} because of an invalid quaternion "
            f"in the transform {_numbers(rotation)}"
        )


def _numbers(values: tuple[float, ...]) -> str:
    return "(" + " ".join(f"{v:f}" for v in values) + ")"


def rotation_advice(child: str, rotation: Quaternion) -> str:
    """Advice on a rotation that is no unit quaternion; empty for one that is.

    Args:
        child: Frame whose orientation it is.
        rotation: What was broadcast, xyzw.
    """
    norm = math.sqrt(sum(c * c for c in rotation))
    if abs(norm * norm - 1.0) < NORM_TOLERANCE:
        return ""
    if math.isnan(norm):
        return f'The rotation of "{child}" contains NaN: a division by zero or an empty message?'
    if norm == 0.0:
        return (
            f'The rotation of "{child}" is all zeros, as in a new message; "not turned" is '
            "(0, 0, 0, 1)."
        )
    return (
        f'The rotation of "{child}" has the norm {norm:.3g} instead of 1. If these are angles, '
        "use quaternion_from_euler(roll, pitch, yaw), which gives (x, y, z, w)."
    )


class BroadcasterWatch:
    """Remembers who broadcast each frame.

    A node that takes over from another is no fault; two that alternate are, which tf does not report.
    """

    def __init__(self) -> None:
        self._last: dict[str, str] = {}
        self._parents: dict[str, dict[str, str]] = {}
        self._reported: set[str] = set()

    def note(self, child: str, parent: str, *, authority: str) -> str:
        """Note one broadcast.

        Args:
            child: Frame that was broadcast.
            parent: Its parent in this broadcast.
            authority: The node that sent it.

        Returns:
            A sentence, the first time that a former broadcaster sends again; else empty.
        """
        parents = self._parents.setdefault(child, {})
        alternates = authority in parents and self._last[child] != authority
        parents[authority] = parent
        self._last[child] = authority
        if not alternates or child in self._reported:
            return ""
        self._reported.add(child)
        who = " and ".join(f"{name} (parent {under})" for name, under in parents.items())
        return (
            f'Frame "{child}" has {len(parents)} broadcasters: {who}. '
            "A frame has one parent and one broadcaster; it jumps between them."
        )
