"""Inertias that have the right numbers about the wrong axes."""

from __future__ import annotations

import itertools

from simkit.geometry import Vector
from simkit.urdf.frame import Frame
from simkit.urdf.inertia import shape_tensor, turned
from simkit.urdf.matrix import Matrix, product, rotation_matrix, transpose
from simkit.urdf.rules.bodies import frame_of, solid, tensor_of
from simkit.urdf.rules.entries import LinkEntry
from simkit.urdf.rules.paste import tensor_text, triple

_SAME, _OTHER = 0.03, 0.1
"Shares of a tensor's trace: entries that differ by less are the same, by more are not."


def is_swapped(link: LinkEntry, written: Matrix) -> bool:
    """Whether a tensor fits the only shape of a link, but in another order of its axes."""
    relative = _shape_in_inertial(link)
    if relative is None:
        return False
    tensor = turned(written, transpose(relative.rotation))
    trace = tensor[0][0] + tensor[1][1] + tensor[2][2]
    if max(abs(tensor[0][1]), abs(tensor[0][2]), abs(tensor[1][2])) > _SAME * trace:
        return False
    own = _shares((tensor[0][0], tensor[1][1], tensor[2][2]))
    shape = shape_tensor(solid(link)[0].shape, 1.0)
    right = _shares((shape[0][0], shape[1][1], shape[2][2]))
    orders = [_distance(own, (a, b, c)) for a, b, c in itertools.permutations(right)]
    return _distance(own, right) > _OTHER and min(orders) < _SAME


def _shape_in_inertial(link: LinkEntry) -> Frame | None:
    """Where the only shape of a link stands in its `<inertial>`; None if there are more."""
    shapes = solid(link)
    frame = None if link.inertial is None else frame_of(link.inertial.origin)
    if len(shapes) != 1 or frame is None:
        return None
    return frame.from_here(shapes[0].frame)


def swapped_remedy(link: LinkEntry, fitting: Matrix) -> str:
    """What would be right, for a link whose inertia is of that kind; `fitting` is the tensor of its shape."""
    here = f"Write {tensor_text(fitting)}"
    shape = (link.collisions or link.visuals)[0].origin
    rpy = shape.rpy
    if link.inertial is None or rpy is None or link.inertial.origin.rpy == rpy:
        return f"{here}."
    in_shape = _turned_back(fitting, link.inertial.origin.rpy, rpy)
    same = tensor_of(link.inertial)
    if same is None or _distance(_diagonal_shares(in_shape), _diagonal_shares(same)) > _SAME:
        return f"{here}."
    return f'Give the <origin> of the <inertial> the angles of the shape, rpy="{triple(rpy)}". Or {here[0].lower()}{here[1:]}.'


def _turned_back(tensor: Matrix, rpy: Vector | None, shape_rpy: Vector) -> Matrix:
    """A tensor in the axes of an `<inertial>`, in those of the shape."""
    rotation = rotation_matrix(rpy or (0.0, 0.0, 0.0))
    return turned(tensor, product(transpose(rotation_matrix(shape_rpy)), rotation))


def _shares(moments: Vector) -> Vector:
    whole = sum(moments)
    return (moments[0] / whole, moments[1] / whole, moments[2] / whole)


def _diagonal_shares(tensor: Matrix) -> Vector:
    return _shares((tensor[0][0], tensor[1][1], tensor[2][2]))


def _distance(left: Vector, right: Vector) -> float:
    return max(abs(a - b) for a, b in zip(left, right, strict=True))
