"""Quaternions (x, y, z, w) as tf2 computes with them: products without normalisation."""

from __future__ import annotations

import math
from math import acos, sin, sqrt  # by name: slerp is in the path of every lookup

from simkit.tf.transform import Quaternion, Transform, Vector


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


def compose(outer: Transform, inner: Transform) -> Transform:
    """T_ac = T_ab T_bc, for T_ab = `outer` and T_bc = `inner`; the stamp is that of `outer`."""
    x, y, z = rotate(outer.rotation, inner.translation)
    tx, ty, tz = outer.translation
    return Transform(
        (tx + x, ty + y, tz + z), multiply(outer.rotation, inner.rotation), outer.stamp
    )


def inverse(transform: Transform) -> Transform:
    """T_ba of T_ab."""
    back = conjugate(transform.rotation)
    x, y, z = transform.translation
    return Transform(rotate(back, (-x, -y, -z)), back, transform.stamp)


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


def through_matrix(q: Quaternion) -> Quaternion:
    """The quaternion that is left of `q` after a detour over a rotation matrix.

    It has unit length, and its sign is fixed: w is positive if the trace of the matrix is
    (|w| > 1/2), else the largest of x, y, z is. tf2 takes this detour where it converts to
    `tf2::Transform`: in the lookup with a fixed frame, and in tf_echo.
    """
    norm = math.sqrt(sum(c * c for c in q))
    x, y, z, w = (c / norm for c in q)
    leading = w if abs(w) > 0.5 else max((x, y, z), key=abs)
    if leading >= 0.0:
        return (x, y, z, w)
    # 0 - x rather than -x: a matrix leaves no negative zeros.
    return (0.0 - x, 0.0 - y, 0.0 - z, 0.0 - w)


def roll_pitch_yaw(q: Quaternion) -> Vector:
    """Angles (roll, pitch, yaw) [rad] about the fixed axes x, y, z, pitch in [-π/2, π/2].

    Source:
        tf `Matrix3x3::getRPY`, first solution; at the poles yaw is 0 and roll takes the rest.
    """
    x, y, z, w = through_matrix(q)
    m20 = 2.0 * (x * z - y * w)
    m01, m02 = 2.0 * (x * y - z * w), 2.0 * (x * z + y * w)
    if m20 <= -1.0:
        return (math.atan2(m01, m02), math.pi / 2.0, 0.0)
    if m20 >= 1.0:
        return (math.atan2(-m01, -m02), -math.pi / 2.0, 0.0)
    m00, m10 = 1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + z * w)
    m21, m22 = 2.0 * (y * z + x * w), 1.0 - 2.0 * (x * x + y * y)
    return (math.atan2(m21, m22), -math.asin(m20), math.atan2(m10, m00))
