"""Joints as urdfdom reads them: any fault in one, and the whole robot is refused."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from simkit.geometry import Vector
from simkit.urdf.model import Joint, JointType, Limit, Mimic, Pose, Safety
from simkit.urdf.urdfdom.numbers import Log, MalformedError, number_of, origin_of, to_vector
from simkit.xml import Element

_TYPES = {type_.value: type_ for type_ in JointType}
_WITHOUT_AXIS = (JointType.FIXED, JointType.FLOATING)
_NEEDS_LIMIT = {
    JointType.REVOLUTE: "Joint [{}] is of type REVOLUTE but it does not specify limits",
    JointType.PRISMATIC: "Joint [{}] is of type PRISMATIC without limits",
}
_NO_NUMBER = "{0} value ({{}}) is not a valid float"


def read_joint(element: Element, log: Log) -> Joint | None:
    """A joint; None, with urdfdom's complaints, if it has a fault.

    Args:
        element: Its element.
        log: Takes the complaints.
    """
    name = element.written("name")
    if name is None:
        log.error("unnamed joint found")
        return None
    try:
        return _Reader(element, log, name).joint()
    except MalformedError as fault:
        log.error(str(fault))
        return None


class _Reader:
    """Reads one joint; urdfdom's order of parts decides which of two faults is named."""

    def __init__(self, element: Element, log: Log, name: str) -> None:
        self._element = element
        self._log = log
        self._name = name

    def joint(self) -> Joint:
        """The joint."""
        origin = self._origin()
        type_ = self._type()
        axis = self._axis(type_)
        limit = self._limit(type_)
        safety = self._safety()
        self._check_calibration()
        mimic = self._mimic()
        damping, friction = self._dynamics()
        return Joint(
            name=self._name,
            type=type_,
            parent=self._link("parent"),
            child=self._link("child"),
            origin=origin,
            axis=axis,
            limit=limit,
            damping=damping,
            friction=friction,
            mimic=mimic,
            safety=safety,
            element=self._element,
        )

    def _link(self, role: str) -> str:
        holder = self._element.child(role)
        return "" if holder is None else holder.written("link") or ""

    def _origin(self) -> Pose:
        with self._part(f"Malformed parent origin element for joint [{self._name}]"):
            return origin_of(self._element)

    def _type(self) -> JointType:
        written = self._element.written("type")
        if written is None:
            raise MalformedError(
                f"joint [{self._name}] has no type, check to see if it's a reference."
            )
        if written not in _TYPES:
            raise MalformedError(f"Joint [{self._name}] has no known type [{written}]")
        return _TYPES[written]

    def _axis(self, type_: JointType) -> Vector:
        """The axis: x without an `<axis>`, zero without its xyz; not looked at where none is needed."""
        axis = self._element.child("axis")
        if axis is None or type_ in _WITHOUT_AXIS:
            return (1.0, 0.0, 0.0)
        xyz = axis.written("xyz")
        if xyz is None:
            return (0.0, 0.0, 0.0)
        try:
            return to_vector(xyz)
        except MalformedError as fault:
            raise MalformedError(
                f"Malformed axis element for joint [{self._name}]: {fault}"
            ) from None

    def _limit(self, type_: JointType) -> Limit | None:
        limit = self._element.child("limit")
        if limit is None and type_ in _NEEDS_LIMIT:
            raise MalformedError(_NEEDS_LIMIT[type_].replace("{}", self._name))
        if limit is None:
            return None
        with self._part(f"Could not parse limit element for joint [{self._name}]"):
            return Limit(
                lower=_number(limit, "lower", 0.0),
                upper=_number(limit, "upper", 0.0),
                effort=_needed(limit, "effort", "joint limit: no effort"),
                velocity=_needed(limit, "velocity", "joint limit: no velocity"),
            )

    def _safety(self) -> Safety | None:
        safety = self._element.child("safety_controller")
        if safety is None:
            return None
        with self._part(f"Could not parse safety element for joint [{self._name}]"):
            return Safety(
                soft_lower=_number(safety, "soft_lower_limit", 0.0),
                soft_upper=_number(safety, "soft_upper_limit", 0.0),
                k_position=_number(safety, "k_position", 0.0),
                k_velocity=_needed(safety, "k_velocity", "joint safety: no k_velocity"),
            )

    def _check_calibration(self) -> None:
        calibration = self._element.child("calibration")
        if calibration is None:
            return
        with self._part(f"Could not parse calibration element for joint  [{self._name}]"):
            _number(calibration, "rising", 0.0)
            _number(calibration, "falling", 0.0)

    def _mimic(self) -> Mimic | None:
        mimic = self._element.child("mimic")
        if mimic is None:
            return None
        with self._part(f"Could not parse mimic element for joint  [{self._name}]"):
            master = mimic.written("joint")
            if master is None:
                raise MalformedError("joint mimic: no mimic joint specified")
            multiplier = _number(mimic, "multiplier", 1.0)
            return Mimic(joint=master, multiplier=multiplier, offset=_number(mimic, "offset", 0.0))

    def _dynamics(self) -> tuple[float, float]:
        dynamics = self._element.child("dynamics")
        if dynamics is None:
            return (0.0, 0.0)
        with self._part(f"Could not parse joint_dynamics element for joint [{self._name}]"):
            damping = _number(dynamics, "damping", 0.0)
            friction = _number(dynamics, "friction", 0.0)
            if dynamics.written("damping") is None and dynamics.written("friction") is None:
                raise MalformedError(
                    "joint dynamics element specified with no damping and no friction"
                )
            return damping, friction

    @contextmanager
    def _part(self, complaint: str) -> Iterator[None]:
        """A part of the joint: of a fault in it urdfdom complains twice, the second time in these words."""
        try:
            yield
        except MalformedError as fault:
            self._log.error(str(fault))
            raise MalformedError(complaint) from None


def _number(element: Element, name: str, default: float) -> float:
    if element.written(name) is None:
        return default
    return number_of(element, name, _NO_NUMBER.format(name))


def _needed(element: Element, name: str, complaint: str) -> float:
    if element.written(name) is None:
        raise MalformedError(complaint)
    return number_of(element, name, _NO_NUMBER.format(name))
