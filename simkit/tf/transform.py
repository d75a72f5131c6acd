"""What a lookup answers: a rigid transform, and the time that it holds for."""

from __future__ import annotations

from typing import NamedTuple

from simkit.geometry import Quaternion, Transform, Vector


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
