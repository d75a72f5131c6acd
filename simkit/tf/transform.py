"""The values that TF computes with: plain tuples of floats, metres and radians."""

from __future__ import annotations

from typing import NamedTuple, TypeAlias

Vector: TypeAlias = tuple[float, float, float]
"x, y, z [m]."

Quaternion: TypeAlias = tuple[float, float, float, float]
"x, y, z, w; as it was broadcast, which tf2 never normalises."

IDENTITY: Quaternion = (0.0, 0.0, 0.0, 1.0)
ORIGIN: Vector = (0.0, 0.0, 0.0)


class Transform(NamedTuple):
    """T_ab: takes coordinates in frame b (source) to coordinates in frame a (target).

    A named tuple rather than a dataclass: a lookup makes one in a third of the time.
    """

    translation: Vector
    "Origin of b seen from a [m]."
    rotation: Quaternion
    "Orientation of b seen from a, xyzw."
    stamp: int
    "Time the transform holds for [ns]."
