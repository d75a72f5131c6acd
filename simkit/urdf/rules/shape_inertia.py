"""Rules about the inertia of a link beside that of its shapes."""

from __future__ import annotations

import enum
import itertools
from collections.abc import Iterator

from simkit.diagnostics import Find, Severity, rule
from simkit.geometry import Matrix, Transform, Vector, matrix_from_rpy
from simkit.urdf.inertia import (
    eigenvalues,
    gyration_radius,
    product,
    shape_tensor,
    transpose,
    turned,
)
from simkit.urdf.model import Cylinder
from simkit.urdf.rules.bodies import (
    counts,
    fitting_tensor,
    frame_of,
    link_outline,
    lumps,
    mass_of,
    reach,
    solid,
    tensor_of,
)
from simkit.urdf.rules.entries import LinkEntry
from simkit.urdf.rules.inertia import has_odd_moment, is_plausible, tensor_element, tensor_remedy
from simkit.urdf.rules.sheet import Sheet
from simkit.urdf.rules.wording import called, four_digits, tensor_text, triple

_SAME, _OTHER = 0.03, 0.1
"Shares of a tensor's trace: entries that differ by less are the same, by more are not."


def is_swapped(link: LinkEntry, written: Matrix) -> bool:
    """Whether a tensor fits the only shape of a link, but in another order of its axes."""
    relative = _shape_in_inertial(link)
    if relative is None:
        return False
    tensor = turned(written, transpose(relative.matrix))
    trace = tensor[0][0] + tensor[1][1] + tensor[2][2]
    if max(abs(tensor[0][1]), abs(tensor[0][2]), abs(tensor[1][2])) > _SAME * trace:
        return False
    own = _shares((tensor[0][0], tensor[1][1], tensor[2][2]))
    shape = shape_tensor(solid(link)[0].shape, 1.0)
    right = _shares((shape[0][0], shape[1][1], shape[2][2]))
    orders = [_distance(own, (a, b, c)) for a, b, c in itertools.permutations(right)]
    return _distance(own, right) > _OTHER and min(orders) < _SAME


def _shape_in_inertial(link: LinkEntry) -> Transform | None:
    """Where the only shape of a link stands in its `<inertial>`; None if there are more."""
    shapes = solid(link)
    frame = None if link.inertial is None else frame_of(link.inertial.origin)
    if len(shapes) != 1 or frame is None:
        return None
    return frame.inverse() @ shapes[0].frame


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
    rotation = matrix_from_rpy(rpy or (0.0, 0.0, 0.0))
    return turned(tensor, product(transpose(matrix_from_rpy(shape_rpy)), rotation))


def _shares(moments: Vector) -> Vector:
    whole = sum(moments)
    return (moments[0] / whole, moments[1] / whole, moments[2] / whole)


def _diagonal_shares(tensor: Matrix) -> Vector:
    return _shares((tensor[0][0], tensor[1][1], tensor[2][2]))


def _distance(left: Vector, right: Vector) -> float:
    return max(abs(a - b) for a, b in zip(left, right, strict=True))


_WIDER = 1.05
"A radius of gyration that exceeds the reach of the shape by less may be rounded."
_NOTED, _WARNED = 3.0, 10.0
"From these factors between an inertia and that of its shape on, it is reported."

_UNITS = {1e3: "g m²", 1e4: "kg cm²", 1e6: "kg mm²", 1e7: "g cm²", 1e9: "g mm²"}
"An inertia in a wrong unit is too large by this."


class _Mismatch(enum.Enum):
    SWAPPED = enum.auto()
    TOO_WIDE = enum.auto()
    FACTOR = enum.auto()


@rule(
    "URDF-W12",
    "an inertia with its axes mixed up",
    Severity.WARNING,
    here="simkit computes with what is written: the link turns too easily about one axis and too hard about another.",
    gazebo="Gazebo computes with what is written, too.",
)
def swapped_axes(sheet: Sheet) -> Iterator[Find]:
    """The inertia has the right numbers about the wrong axes.

    Symptom: A wheel that starts and stops oddly, a robot that leans in bends: the link is easy to turn where it should be
    hard.

    Cause: The tensor is given in the axes of `<inertial><origin>`, not in those of the shape. A cylinder stands along z; a
    wheel is a cylinder turned by 90 degrees. Turn the shape and forget the inertia, and ½ m r², which belongs to the axle,
    sits about another axis.

    Remedy: Give the `<inertial>` the same `rpy` as the shape, or write ½ m r² about the axis that the axle has in the link.

    Right:

        <inertial>
          <origin rpy="1.5708 0 0"/>
          <mass value="0.2"/>
          <inertia ixx="0.0005267" ixy="0" ixz="0" iyy="0.0005267" iyz="0" izz="0.001"/>
        </inertial>
        <collision>
          <origin rpy="1.5708 0 0"/>
          <geometry><cylinder radius="0.1" length="0.04"/></geometry>
        </collision>
    """
    for link, written, fitting, severity in _mismatches(sheet, _Mismatch.SWAPPED):
        yield Find(
            tensor_element(link),
            severity=severity,
            what=f"the inertia of {called(link.element)} has its axes mixed up: it has {_moments(written)} about x, y, z, "
            f"its {_shape_name(link)} has {_moments(fitting)}",
            remedy=swapped_remedy(link, fitting),
        )


@rule(
    "URDF-W13",
    "an inertia that the link is too small for",
    Severity.WARNING,
    here="simkit computes with what is written: the link turns too sluggishly.",
    gazebo="Gazebo computes with what is written, too.",
)
def too_wide(sheet: Sheet) -> Iterator[Find]:
    """An inertia that the link is too small for.

    Symptom: Sluggish wheels, an arm that hardly starts, or a robot that falls over when a small part turns.

    Cause: Mostly the mass or the size of a link was changed and its inertia was not, or the inertia is in other units.
    Spread the whole mass on a ring: its radius of gyration, √(I/m), must lie within the shape. Here it lies outside.

    Remedy: Compute the inertia anew whenever the mass or a size changes. It grows with the mass, and with the square of the
    size.

    Right:

        <!-- 0.01 kg, radius 0.043 m: the ring would have 0.21 m -->
        <inertia ixx="0.00045" ixy="0" ixz="0" iyy="0.00045" iyz="0" izz="0.00001"/>
        <!-- right: 1/2 m r² and so on -->
        <inertia ixx="0.0000055" ixy="0" ixz="0" iyy="0.0000055" iyz="0" izz="0.0000092"/>
    """
    for link, written, fitting, severity in _mismatches(sheet, _Mismatch.TOO_WIDE):
        mass = mass_of(link)
        yield Find(
            tensor_element(link),
            severity=severity,
            what=f"the inertia of {called(link.element)} is too large for it: {four_digits(mass)} kg would have to lie "
            f"{four_digits(gyration_radius(written, mass))} m from the centre, and the link reaches {four_digits(reach(link))} m"
            + _explained(written, fitting, mass),
            remedy=tensor_remedy(link),
        )


@rule(
    "URDF-W43",
    "an inertia far from that of the shape",
    Severity.WARNING,
    here="simkit computes with what is written.",
    gazebo="Gazebo computes with what is written.",
)
def other_size(sheet: Sheet) -> Iterator[Find]:
    """The inertia is far from that of the shape.

    Symptom: The link turns much more easily, or much harder, than a thing of that size and mass.

    Cause: An inertia that was copied from another link, computed in other units (g, cm, mm), or left as it was when mass or
    size changed. A small difference is normal: real parts are not filled evenly, and a collision shape is only roughly
    theirs.

    Remedy: Compare with the values of the shape, and keep yours only if you know better.

    Right:

        <!-- a box of 1 kg, 0.6 x 0.4 x 0.2 m -->
        <inertia ixx="0.01667" ixy="0" ixz="0" iyy="0.03333" iyz="0" izz="0.04333"/>
    """
    for link, written, fitting, severity in _mismatches(sheet, _Mismatch.FACTOR):
        factor = _factor(written, fitting)
        word = "larger" if factor > 1.0 else "smaller"
        size = four_digits(max(factor, 1.0 / factor))
        is_far = _is_far(factor) and link_outline(link)
        yield Find(
            tensor_element(link),
            severity=severity if is_far else Severity.NOTE,
            what=f"the inertia of {called(link.element)} is up to {size} times {word} than that of its shape"
            + _explained(written, fitting, mass_of(link)),
            remedy=tensor_remedy(link),
        )


def _mismatches(
    sheet: Sheet, kind: _Mismatch
) -> Iterator[tuple[LinkEntry, Matrix, Matrix, Severity]]:
    """The links with that fault.

    Yields:
        A link, its tensor, the one of its shape in the same axes, and how bad it is: it is only worth a note where the link
        cannot turn, or is a small part of something larger.
    """
    lump_of = lumps(sheet)
    for link in sheet.links:
        written = None if link.inertial is None or not mass_of(link) else tensor_of(link.inertial)
        if written is None or not is_plausible(written):
            continue
        fitting = fitting_tensor(link)
        if fitting is not None and _mismatch(link, written, fitting) is kind:
            matters = counts(lump_of.get(link.name or ""), link)
            yield link, written, fitting, Severity.WARNING if matters else Severity.NOTE


def _mismatch(link: LinkEntry, written: Matrix, fitting: Matrix) -> _Mismatch | None:
    if is_swapped(link, written) and 1.0 / _NOTED < _traces(written, fitting) < _NOTED:
        return _Mismatch.SWAPPED
    if has_odd_moment(link, written):
        return None
    size = reach(link)
    if link_outline(link) and gyration_radius(written, mass_of(link)) > _WIDER * size:
        return _Mismatch.TOO_WIDE
    factor = _factor(written, fitting)
    limit = _NOTED if link_outline(link) else _WARNED
    return None if 1.0 / limit < factor < limit else _Mismatch.FACTOR


def _factor(written: Matrix, fitting: Matrix) -> float:
    """The ratio of principal moments that is farthest from 1."""
    ratios = _ratios(written, fitting)
    return max(ratios, key=lambda ratio: max(ratio, 1.0 / ratio))


def _ratios(written: Matrix, fitting: Matrix) -> tuple[float, float, float]:
    (a, b, c), (d, e, f) = eigenvalues(written), eigenvalues(fitting)
    return (a / d, b / e, c / f)


def _traces(written: Matrix, fitting: Matrix) -> float:
    return sum(written[axis][axis] for axis in range(3)) / sum(
        fitting[axis][axis] for axis in range(3)
    )


def _is_far(factor: float) -> bool:
    return not 1.0 / _WARNED < factor < _WARNED


def _explained(written: Matrix, fitting: Matrix, mass: float) -> str:
    """Where such an inertia may come from, if all its moments are off by the same factor."""
    ratios = _ratios(written, fitting)
    if max(ratios) > 1.1 * min(ratios):
        return ""
    for factor, unit in _UNITS.items():
        if 0.9 < ratios[0] / factor < 1.1:
            return f"; as if it were written in {unit}"
    is_likely = 0.005 < ratios[0] < 200.0
    return f"; it fits a mass of {four_digits(mass * ratios[0])} kg" if is_likely else ""


def _moments(tensor: Matrix) -> str:
    return ", ".join(four_digits(tensor[axis][axis]) for axis in range(3))


def _shape_name(link: LinkEntry) -> str:
    return "cylinder" if isinstance(solid(link)[0].shape, Cylinder) else "shape"
