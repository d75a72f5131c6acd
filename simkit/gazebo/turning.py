"""Vectors in and out of the frame of something that stands askew."""

from __future__ import annotations

from simkit.geometry import Vector
from simkit.urdf.kinematics import Placement, compose, inverse

_STILL = (0.0, 0.0, 0.0, 1.0)


def turned(frame: Placement, vector: Vector) -> Vector:
    """A vector of a frame, in the world."""
    return compose(
        Placement((0.0, 0.0, 0.0), frame.rotation), Placement(vector, _STILL)
    ).translation


def turned_back(frame: Placement, vector: Vector) -> Vector:
    """A vector of the world, in a frame."""
    return turned(inverse(Placement((0.0, 0.0, 0.0), frame.rotation)), vector)
