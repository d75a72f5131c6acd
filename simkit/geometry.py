"""The geometry of simkit: vectors, unit quaternions and rigid transforms, as plain tuples of floats.

Conventions, everywhere: metres, radians, right-handed axes. A quaternion is (x, y, z, w), as in ROS
messages. `T_ab` is the pose of frame b in frame a; it takes coordinates in b to coordinates in a, so
`T_ac = T_ab @ T_bc` and `p_a = T_ab.apply(p_b)`. Roll, pitch and yaw turn about the *fixed* axes x,
y, z, in this order: `R = Rz(yaw) Ry(pitch) Rx(roll)`.

As in tf2, products do not normalise: a quaternion that is not of unit length stays so, and scales
what it rotates by its squared length. `normalised` and `canonical` mend that where it matters.

Tuples rather than numpy arrays: three or four numbers are computed faster so, they are frozen and
hashable, and a program that only reads a robot does not load numpy.
"""

from __future__ import annotations

import math
from math import acos, cos, sin, sqrt  # by name: TF lookups live on these
from typing import Final, NamedTuple, TypeAlias

Vector: TypeAlias = tuple[float, float, float]
"x, y, z [m, unless it says otherwise]."

Quaternion: TypeAlias = tuple[float, float, float, float]
"x, y, z, w."

Matrix: TypeAlias = tuple[Vector, Vector, Vector]
"A matrix of 3 by 3, as rows: a rotation or an inertia tensor."

ORIGIN: Final[Vector] = (0.0, 0.0, 0.0)
IDENTITY: Final[Quaternion] = (0.0, 0.0, 0.0, 1.0)
IDENTITY_MATRIX: Final[Matrix] = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


class Transform(NamedTuple):
    """T_ab: the pose of frame b in frame a; takes coordinates in b to coordinates in a."""

    translation: Vector = ORIGIN
    """Origin of b in a [m]."""
    rotation: Quaternion = IDENTITY
    """Orientation of b in a, xyzw."""

    @classmethod
    def from_rpy(cls, translation: Vector, rpy: Vector) -> Transform:
        """T_ab of a translation [m] and roll, pitch, yaw [rad]: what an `<origin>` says."""
        return cls(translation, canonical(quaternion_from_rpy(rpy)))

    @classmethod
    def from_matrix(cls, translation: Vector, rotation: Matrix) -> Transform:
        """T_ab of a translation [m] and R_ab as rows."""
        return cls(translation, quaternion_from_matrix(rotation))

    def __matmul__(self, inner: Transform) -> Transform:
        """T_ac = T_ab @ T_bc."""
        x, y, z = rotate(self.rotation, inner.translation)
        tx, ty, tz = self.translation
        return Transform((tx + x, ty + y, tz + z), multiply(self.rotation, inner.rotation))

    def inverse(self) -> Transform:
        """T_ba."""
        back = conjugate(self.rotation)
        x, y, z = self.translation
        return Transform(rotate(back, (-x, -y, -z)), back)

    def apply(self, point: Vector) -> Vector:
        """p_a of a point p_b [m]."""
        x, y, z = rotate(self.rotation, point)
        tx, ty, tz = self.translation
        return (tx + x, ty + y, tz + z)

    def apply_back(self, point: Vector) -> Vector:
        """p_b of a point p_a [m]."""
        x, y, z = point
        tx, ty, tz = self.translation
        return rotate(conjugate(self.rotation), (x - tx, y - ty, z - tz))

    def rotate(self, vector: Vector) -> Vector:
        """A direction, velocity or force known in b, seen in a: without the translation."""
        return rotate(self.rotation, vector)

    def rotate_back(self, vector: Vector) -> Vector:
        """A direction, velocity or force known in a, seen in b."""
        return rotate(conjugate(self.rotation), vector)

    @property
    def matrix(self) -> Matrix:
        """R_ab as rows."""
        return matrix_from_quaternion(self.rotation)

    @property
    def rpy(self) -> Vector:
        """Roll, pitch, yaw [rad] of b in a."""
        return roll_pitch_yaw(self.rotation)

    def normalised(self) -> Transform:
        """The same with a quaternion of unit length: so long chains of products do not drift."""
        return Transform(self.translation, normalised(self.rotation))


def multiply(q1: Quaternion, q0: Quaternion) -> Quaternion:
    """Hamilton product q1 q0: the rotation q0, then the rotation q1."""
    x1, y1, z1, w1 = q1
    x0, y0, z0, w0 = q0
    return (
        w1 * x0 + x1 * w0 + y1 * z0 - z1 * y0,
        w1 * y0 - x1 * z0 + y1 * w0 + z1 * x0,
        w1 * z0 + x1 * y0 - y1 * x0 + z1 * w0,
        w1 * w0 - x1 * x0 - y1 * y0 - z1 * z0,
    )


def conjugate(q: Quaternion) -> Quaternion:
    """The inverse of a unit quaternion; tf2 takes it for the inverse of any."""
    x, y, z, w = q
    return (-x, -y, -z, w)


def rotate(q: Quaternion, v: Vector) -> Vector:
    """The sandwich q v q*: rotates `v`, and scales it by |q|² if q is not a unit quaternion."""
    x, y, z, w = q
    a, b, c = v
    # t = 2 u x v turns the sandwich into |q|² v + w t + u x t.
    tx = 2.0 * (y * c - z * b)
    ty = 2.0 * (z * a - x * c)
    tz = 2.0 * (x * b - y * a)
    scale = x * x + y * y + z * z + w * w
    return (
        scale * a + w * tx + y * tz - z * ty,
        scale * b + w * ty + z * tx - x * tz,
        scale * c + w * tz + x * ty - y * tx,
    )


def slerp(q0: Quaternion, q1: Quaternion, ratio: float) -> Quaternion:
    """Rotation on the shorter great circle from `q0` (ratio 0) to `q1` (ratio 1).

    Stays in the hemisphere of `q0`; equal rotations give `q0` itself.

    Source:
        tf2 `Quaternion::slerp`: the angle comes from the arc cosine of the normalised product.
    """
    x0, y0, z0, w0 = q0
    x1, y1, z1, w1 = q1
    dot = x0 * x1 + y0 * y1 + z0 * z1 + w0 * w1
    norms = sqrt((x0 * x0 + y0 * y0 + z0 * z0 + w0 * w0) * (x1 * x1 + y1 * y1 + z1 * z1 + w1 * w1))
    cosine = abs(dot) / norms
    if cosine >= 1.0:
        return q0
    angle = acos(cosine)
    sine = sin(angle)
    a = sin((1.0 - ratio) * angle) / sine
    b = sin(ratio * angle) / sine
    if dot < 0.0:
        b = -b
    return (a * x0 + b * x1, a * y0 + b * y1, a * z0 + b * z1, a * w0 + b * w1)


def normalised(q: Quaternion) -> Quaternion:
    """The same rotation as a quaternion of unit length."""
    x, y, z, w = q
    length = sqrt(x * x + y * y + z * z + w * w)
    return (x / length, y / length, z / length, w / length)


def canonical(q: Quaternion) -> Quaternion:
    """The unit quaternion of a rotation with the sign that a rotation matrix gives it.

    w is positive if the trace of the matrix is (|w| > 1/2), else the largest of x, y, z is. tf2
    takes this detour over a matrix where it converts to `tf2::Transform`: in the lookup with a
    fixed frame, and in tf_echo; KDL takes it in every segment.
    """
    norm = math.sqrt(sum(c * c for c in q))
    x, y, z, w = (c / norm for c in q)
    leading = w if abs(w) > 0.5 else max((x, y, z), key=abs)
    if leading >= 0.0:
        return (x, y, z, w)
    # 0 - x rather than -x: a matrix leaves no negative zeros.
    return (0.0 - x, 0.0 - y, 0.0 - z, 0.0 - w)


def quaternion_from_axis(axis: Vector, angle: float) -> Quaternion:
    """A turn by an angle [rad] about an axis of unit length; an axis of zeros turns nothing."""
    s = sin(angle / 2.0)
    return (axis[0] * s, axis[1] * s, axis[2] * s, cos(angle / 2.0)) if any(axis) else IDENTITY


def quaternion_from_z(direction: Vector) -> Quaternion:
    """The shortest turn that takes the axis z to a direction of unit length."""
    x, y, z = direction
    if z < -0.999999:
        return (1.0, 0.0, 0.0, 0.0)
    norm = sqrt(2.0 * (1.0 + z))
    return (-y / norm, x / norm, 0.0, norm / 2.0)


def quaternion_from_rpy(rpy: Vector) -> Quaternion:
    """Rz Ry Rx of roll, pitch, yaw [rad]; q and -q are one rotation, and either may come."""
    sin_r, sin_p, sin_y = (sin(angle / 2.0) for angle in rpy)
    cos_r, cos_p, cos_y = (cos(angle / 2.0) for angle in rpy)
    return (
        sin_r * cos_p * cos_y - cos_r * sin_p * sin_y,
        cos_r * sin_p * cos_y + sin_r * cos_p * sin_y,
        cos_r * cos_p * sin_y - sin_r * sin_p * cos_y,
        cos_r * cos_p * cos_y + sin_r * sin_p * sin_y,
    )


def roll_pitch_yaw(q: Quaternion) -> Vector:
    """Roll, pitch, yaw [rad] about the fixed axes x, y, z, pitch in [-π/2, π/2].

    Source:
        tf `Matrix3x3::getRPY`, first solution; at the poles yaw is 0 and roll takes the rest.
    """
    x, y, z, w = canonical(q)
    m20 = 2.0 * (x * z - y * w)
    m01, m02 = 2.0 * (x * y - z * w), 2.0 * (x * z + y * w)
    if m20 <= -1.0:
        return (math.atan2(m01, m02), math.pi / 2.0, 0.0)
    if m20 >= 1.0:
        return (math.atan2(-m01, -m02), -math.pi / 2.0, 0.0)
    m00, m10 = 1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + z * w)
    m21, m22 = 2.0 * (y * z + x * w), 1.0 - 2.0 * (x * x + y * y)
    return (math.atan2(m21, m22), -math.asin(m20), math.atan2(m10, m00))


def matrix_from_rpy(rpy: Vector) -> Matrix:
    """R = Rz Ry Rx of roll, pitch, yaw [rad], as rows."""
    return matrix_from_quaternion(quaternion_from_rpy(rpy))


def matrix_from_quaternion(q: Quaternion) -> Matrix:
    """R of a unit quaternion, as rows."""
    x, y, z, w = q
    return (
        (1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)),
        (2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)),
        (2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)),
    )


def quaternion_from_matrix(matrix: Matrix) -> Quaternion:
    """The unit quaternion of a rotation; w is not negative unless it is small.

    Source:
        Shepperd's method: divide by the largest of the four.
    """
    (a, b, c), (d, e, f), (g, h, i) = matrix
    trace = a + e + i
    if trace > 0.0:
        s = 2.0 * sqrt(1.0 + trace)
        return ((h - f) / s, (c - g) / s, (d - b) / s, s / 4.0)
    if a >= e and a >= i:
        s = 2.0 * sqrt(1.0 + a - e - i)
        return (s / 4.0, (b + d) / s, (c + g) / s, (h - f) / s)
    if e >= i:
        s = 2.0 * sqrt(1.0 + e - a - i)
        return ((b + d) / s, s / 4.0, (f + h) / s, (c - g) / s)
    s = 2.0 * sqrt(1.0 + i - a - e)
    return ((c + g) / s, (f + h) / s, s / 4.0, (d - b) / s)
