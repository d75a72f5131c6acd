"""Where rays hit solids that stand in the origin: formulas, over arrays of rays.

Each function takes origins [m] and unit directions in the frame of the solid, (3, n) or (3, 1) for
all rays, and returns the distance to the first point of the surface ahead [m], (n,); inf if there
is none. Coordinates come first, so that each is one piece of memory. Rays along a face divide by
zero, and roots of negative numbers are misses: whoever calls these functions has numpy keep quiet.
"""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

Floats: TypeAlias = NDArray[np.float64]

MOST_AT_ONCE = 1_000_000
"""So many pairs of a ray and a triangle are looked at in one go: about 100 MB."""
_EDGE = 1e-12
"A ray that hits the edge between two triangles hits one of them."


def hit_box(origins: Floats, directions: Floats, half: tuple[float, float, float]) -> Floats:
    """A box.

    Args:
        origins: Where the rays start.
        directions: Where they go.
        half: Half of its lengths [m].
    """
    sides = np.array(half)[:, None]
    inverse = 1.0 / directions
    one, other = (-sides - origins) * inverse, (sides - origins) * inverse
    # fmin and fmax pass over NaN: 0 * inf, of a ray within a face.
    entry = np.fmax.reduce(np.fmin(one, other), axis=0)
    leave = np.fmin.reduce(np.fmax(one, other), axis=0)
    is_hit = (entry <= leave) & (leave >= 0.0)
    return np.where(is_hit, np.where(entry >= 0.0, entry, leave), np.inf)


def hit_sphere(origins: Floats, directions: Floats, radius: float) -> Floats:
    """A ball of a radius [m]."""
    along = _dot(origins, directions)
    x, y, z = origins - along * directions
    return _first(along, radius * radius - (x * x + y * y + z * z))


def hit_cylinder(origins: Floats, directions: Floats, radius: float, half: float) -> Floats:
    """A cylinder along z of a radius and half a length [m]."""
    (ox, oy, oz), (dx, dy, dz) = origins, directions
    found = np.full(directions.shape[1], np.inf)
    flat = dx * dx + dy * dy
    along = (ox * dx + oy * dy) / flat
    ax, ay = ox - along * dx, oy - along * dy
    spread = np.sqrt((radius * radius - (ax * ax + ay * ay)) / flat)
    for side in (-along - spread, -along + spread):
        is_wall = (side >= 0.0) & (np.abs(oz + side * dz) <= half)
        np.minimum(found, np.where(is_wall, side, np.inf), out=found)
    for height in (-half, half):
        cap = (height - oz) / dz
        px, py = ox + cap * dx, oy + cap * dy
        is_cap = (cap >= 0.0) & (px * px + py * py <= radius * radius)
        np.minimum(found, np.where(is_cap, cap, np.inf), out=found)
    return found


def hit_plane(origins: Floats, directions: Floats, normal: tuple[float, float, float]) -> Floats:
    """A plane through the origin, from both sides.

    Args:
        origins: Where the rays start.
        directions: Where they go.
        normal: Its unit normal.
    """
    up = np.array(normal)
    found = -(up @ origins) / (up @ directions)
    return np.where(found >= 0.0, found, np.inf)


def hit_triangles(origins: Floats, directions: Floats, corners: Floats) -> Floats:
    """Triangles, from both sides.

    Args:
        origins: Where the rays start.
        directions: Where they go.
        corners: Corners of the triangles [m], (m, 3, 3).

    Source:
        Möller and Trumbore, Fast, minimum storage ray/triangle intersection, 1997.
    """
    starts = np.broadcast_to(origins, directions.shape).T
    found = np.full(len(starts), np.inf)
    batch = max(1, MOST_AT_ONCE // max(1, len(corners)))
    for start in range(0, len(found), batch):
        rays = slice(start, start + batch)
        found[rays] = _hit_all(starts[rays], directions.T[rays], corners)
    return found


def _hit_all(origins: Floats, directions: Floats, corners: Floats) -> Floats:
    first, one, other = corners[:, 0], corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    across = np.cross(directions[:, None], other[None])
    away = origins[:, None] - first[None]
    beside = np.cross(away, one[None])
    inverse = 1.0 / np.einsum("ijk,jk->ij", across, one)
    u = np.einsum("ijk,ijk->ij", away, across) * inverse
    v = np.einsum("ik,ijk->ij", directions, beside) * inverse
    distance = np.einsum("jk,ijk->ij", other, beside) * inverse
    is_hit = (u >= -_EDGE) & (v >= -_EDGE) & (u + v <= 1.0 + _EDGE) & (distance >= 0.0)
    nearest: Floats = np.where(is_hit, distance, np.inf).min(axis=1, initial=np.inf)
    return nearest


def _first(along: Floats, spread: Floats) -> Floats:
    """The smaller of -along ± sqrt(spread) that is not behind; inf if there is none."""
    root = np.sqrt(spread)
    near, far = -along - root, -along + root
    return np.where(near >= 0.0, near, np.where(far >= 0.0, far, np.inf))


def _dot(left: Floats, right: Floats) -> Floats:
    """Products of columns."""
    (a, b, c), (x, y, z) = left, right
    products: Floats = a * x + b * y + c * z
    return products
