"""Which joints of a robot are published, how far they go, and which follow others.

The program looks at the XML alone: it takes robots that urdfdom refuses, as long as they are
well-formed.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from simkit.nodes.joint_state_publisher.settings import Crash, SliderSettings, to_number
from simkit.xml import Element, parse_xml
from simkit.xml.parser import words_of_expat

_ENTITY = re.compile(r"<!ENTITY\s+(?:%\s+)?([^\s>]+)")
_LEFT_OUT = ("fixed", "floating", "planar")


@dataclass(slots=True, kw_only=True)
class FreeJoint:
    """A joint with a state of its own."""

    lower: float
    """Smallest position [rad or m]."""
    upper: float
    """Largest position [rad or m]."""
    zero: float
    """Where it begins [rad or m]."""
    is_continuous: bool
    """Whether it turns round and round."""
    unit: str
    """Unit of its position: `rad` or `m`."""
    position: float | None
    """Where it stands [rad or m]; None if it is unknown."""
    velocity: float | None
    """How fast it is [rad/s or m/s]."""
    effort: float | None
    """What drives it [N m or N]."""
    moves_up: bool = True
    """Whether a sweep (`delta`) takes it upward."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Follower:
    """A joint that follows another: position = factor * that of the other + offset."""

    parent: str
    """The joint that it follows."""
    factor: float
    offset: float
    """[rad or m]."""


@dataclass(frozen=True, slots=True, kw_only=True)
class RobotJoints:
    """What was found in a robot."""

    names: tuple[str, ...]
    """Those that are published, in the order of the file."""
    free: dict[str, FreeJoint]
    """Those with a state of their own."""
    followers: dict[str, Follower]
    """Those that follow others, by tag or by parameter."""


def read_joints(settings: SliderSettings, warn: Callable[[str], None]) -> RobotJoints:
    """Find the joints of a robot.

    Args:
        settings: The robot, and what to make of it.
        warn: Logs joints without a range.

    Raises:
        Crash: The text is not well-formed XML, or an attribute is not a number.
    """
    robot = _robot_element(settings.description)
    joints = RobotJoints(names=(), free={}, followers=_followers_of(settings))
    names: list[str] = []
    for element in robot.all("joint"):
        if element.get("type") not in _LEFT_OUT:
            names.append(element.get("name") or "")
            _add(joints, element, settings, warn)
    return RobotJoints(names=tuple(names), free=joints.free, followers=joints.followers)


def _robot_element(text: str) -> Element:
    document = parse_xml(text, file="robot_description")
    entity = _ENTITY.search(text)
    if entity is not None and document.faults:
        raise Crash("", f"robot_description defines an entity, {entity[1]!r}; that is refused here")
    words = words_of_expat(document)
    if words is not None or document.faults:
        fault = words or document.faults[0].what
        raise Crash(
            f"xml.parsers.expat.ExpatError: {fault}",
            "robot_description is not well-formed XML; simkit check_urdf shows the place",
        )
    root = document.root
    found = None if root is None else next((e for e in root.walk() if e.name == "robot"), None)
    if found is None:
        raise Crash(
            "IndexError: list index out of range",
            "robot_description has no element <robot>: is it the text of a URDF file?",
        )
    return found


def _followers_of(settings: SliderSettings) -> dict[str, Follower]:
    return {str(name): _follower(name, entry) for name, entry in settings.dependent_joints.items()}


def _follower(name: str, entry: Any) -> Follower:
    if not isinstance(entry, dict) or "parent" not in entry:
        raise Crash(
            "KeyError: 'parent'",
            f"the parameter dependent_joints/{name} must name the joint that is followed: "
            "{parent: other_joint, factor: 1.0, offset: 0.0}",
        )
    what = f"the parameter dependent_joints/{name}"
    return Follower(
        parent=str(entry["parent"]),
        factor=to_number(entry.get("factor", 1), f"{what}/factor"),
        offset=to_number(entry.get("offset", 0), f"{what}/offset"),
    )


def _add(
    joints: RobotJoints, element: Element, settings: SliderSettings, warn: Callable[[str], None]
) -> None:
    """Put a joint where it belongs; one without a range belongs nowhere."""
    name = element.get("name") or ""
    limits = _range(element)
    if limits is None:
        warn(f"{name} is not fixed, nor continuous, but limits are not specified!")
        return
    mimic = _only(element, "mimic") if settings.use_mimic_tags else None
    if mimic is not None:
        joints.followers[name] = Follower(
            parent=mimic.get("joint") or "",
            factor=_number(mimic, "multiplier", 1.0, name),
            offset=_number(mimic, "offset", 0.0, name),
        )
    elif name not in joints.followers:
        joints.free[name] = _free_joint(name, element, limits, settings)


def _free_joint(
    name: str, element: Element, limits: tuple[float, float], settings: SliderSettings
) -> FreeJoint:
    lower, upper = limits
    soft = _only(element, "safety_controller") if settings.use_smallest_joint_limits else None
    if soft is not None:
        lower = max(lower, _number(soft, "soft_lower_limit", lower, name))
        upper = min(upper, _number(soft, "soft_upper_limit", upper, name))
    zero = (lower + upper) / 2.0 if lower > 0.0 or upper < 0.0 else 0.0
    if name in settings.zeros:
        zero = to_number(settings.zeros[name], f"the parameter zeros/{name}")
    return FreeJoint(
        lower=lower,
        upper=upper,
        zero=zero,
        is_continuous=element.get("type") == "continuous",
        unit="m" if element.get("type") == "prismatic" else "rad",
        position=zero if settings.publish_default_positions else None,
        velocity=0.0 if settings.publish_default_velocities else None,
        effort=0.0 if settings.publish_default_efforts else None,
    )


def _range(element: Element) -> tuple[float, float] | None:
    if element.get("type") == "continuous":
        return (-math.pi, math.pi)
    limit = next((one for one in element.walk() if one.name == "limit"), None)
    if limit is None:
        return None
    try:
        lower, upper = float(limit.get("lower") or ""), float(limit.get("upper") or "")
    except ValueError:
        return None
    return (lower, upper) if math.isfinite(upper - lower) else None


def _only(element: Element, tag: str) -> Element | None:
    """The element below of that name; None if there are several."""
    found = [one for one in element.walk() if one.name == tag]
    return found[0] if len(found) == 1 else None


def _number(element: Element, attribute: str, default: float, joint: str) -> float:
    text = element.get(attribute)
    if text is None:
        return default
    try:
        return float(text)
    except ValueError as error:
        raise Crash(
            f"ValueError: {error}", f"joint {joint}: {attribute}='{text}' is not a number"
        ) from error
