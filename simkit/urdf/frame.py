"""Frames as the rules compute with them: a rotation matrix and an origin, in plain numbers."""

from __future__ import annotations

from typing import NamedTuple

from simkit.geometry import Vector
from simkit.urdf.matrix import IDENTITY, Matrix, apply, product, rotation_matrix, transpose
from simkit.urdf.model import Pose


class Frame(NamedTuple):
    """Where a frame b stands in a frame a: T_ab."""

    rotation: Matrix = IDENTITY
    """R_ab."""
    origin: Vector = (0.0, 0.0, 0.0)
    """Origin of b in a [m]."""

    @classmethod
    def of(cls, pose: Pose) -> Frame:
        """The same as an `<origin>` says it."""
        return cls(rotation_matrix(pose.rpy), pose.xyz)

    def point(self, p_b: Vector) -> Vector:
        """p_a of a point p_b [m]."""
        x, y, z = apply(self.rotation, p_b)
        return (self.origin[0] + x, self.origin[1] + y, self.origin[2] + z)

    def back(self, p_a: Vector) -> Vector:
        """p_b of a point p_a [m]."""
        x, y, z = p_a
        away = (x - self.origin[0], y - self.origin[1], z - self.origin[2])
        return apply(transpose(self.rotation), away)

    def from_here(self, other: Frame) -> Frame:
        """T_bc of T_ac = `other`: a frame c, known in a, seen from b."""
        return Frame(product(transpose(self.rotation), other.rotation), self.back(other.origin))

    def then(self, inner: Frame) -> Frame:
        """T_ac = T_ab T_bc, for T_bc = `inner`."""
        return Frame(product(self.rotation, inner.rotation), self.point(inner.origin))
