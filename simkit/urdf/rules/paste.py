"""Elements with computed values, for a student to paste, and the numbers in them."""

from __future__ import annotations

from simkit.geometry import Vector
from simkit.urdf.inertia import Body, body_of_shapes, turned
from simkit.urdf.matrix import Matrix, rotation_matrix, transpose
from simkit.urdf.placed_shape import PlacedShape
from simkit.urdf.rules.entries import OriginEntry

_STILL = 1e-6
"An entry of a tensor that is a smaller share of the largest one is shown as 0."


def tensor_text(tensor: Matrix) -> str:
    """A tensor as an element to paste, with four digits."""
    (ixx, ixy, ixz), (_, iyy, iyz), (_, _, izz) = tensor
    small = _STILL * max(abs(ixx), abs(iyy), abs(izz))
    named = {"ixx": ixx, "ixy": ixy, "ixz": ixz, "iyy": iyy, "iyz": iyz, "izz": izz}
    texts = [
        f'{name}="{short(0.0 if abs(value) < small else value)}"' for name, value in named.items()
    ]
    return f"<inertia {' '.join(texts)}/>"


def inertial_text(shapes: tuple[PlacedShape, ...], origin: OriginEntry | None, mass: float) -> str:
    """An `<inertial>` to paste for a link that has none.

    Args:
        shapes: What the mass fills, in the frame of the link.
        origin: The `<origin>` of the shape if it is only one: then the tensor is written in its axes.
        mass: Mass [kg].
    """
    body = body_of_shapes(shapes, mass)
    rpy: Vector = (0.0, 0.0, 0.0)
    if origin is not None and origin.rpy is not None:
        rpy = origin.rpy
        body = Body(mass, body.centre, turned(body.tensor, transpose(rotation_matrix(rpy))))
    where = f'<origin xyz="{triple(body.centre)}" rpy="{triple(rpy)}"/>'
    return f'<inertial>{where}<mass value="{short(mass)}"/>{tensor_text(body.tensor)}</inertial>'


def short(number: float) -> str:
    """A number with four digits."""
    text = f"{number:.4g}"
    return "0" if float(text) == 0.0 else text


def triple(vector: Vector) -> str:
    """Three numbers as an attribute holds them, right angles too; what is next to nothing is 0."""
    return " ".join(f"{0.0 if abs(value) < 1e-12 else value:.7g}" for value in vector)
