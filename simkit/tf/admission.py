"""What a broadcast transform must fulfil before a buffer stores it, in tf's words."""

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
