"""Transmissions: which joints of a robot have a motor, and how it is commanded.

Source: transmission_interface `transmission_parser.cpp`, texts and order; `DefaultRobotHWSim::initSim`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TypeAlias

from simkit.graph import LogLevel
from simkit.plugins.control.registry import INTERFACES, PREFIX
from simkit.xml import Element

Say: TypeAlias = Callable[[LogLevel, str], None]
"""Is given what is said of a transmission, and how bad it is."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Transmission:
    """A joint with a motor."""

    joint: str
    """Name of the joint."""
    interface: str
    """How the motor is commanded, without prefix: `PositionJointInterface`."""


def read_transmissions(robot: Element, say: Say) -> list[Transmission]:
    """The transmissions of a URDF that the simulation can use.

    Args:
        robot: The root element.
        say: Is given what is said of all others.
    """
    found = [_read(element, say) for element in robot.all("transmission")]
    return [one for one in found if one is not None]


def _read(element: Element, say: Say) -> Transmission | None:
    name = element.get("name")
    if not name:
        how = "No name attribute" if name is None else "Empty name attribute"
        say(LogLevel.ERROR, f"{how} specified for transmission.")
        return None
    kind = element.child("type")
    if kind is None:
        say(LogLevel.ERROR, f"No type element found in transmission '{name}'.")
        return None
    if not kind.text.strip():
        say(LogLevel.ERROR, f"Skipping empty type element in transmission '{name}'.")
        return None
    joints = _joints(element, say)
    if not joints:
        say(LogLevel.ERROR, f"Failed to load joints for transmission '{name}'.")
        _advise(element, say)
        return None
    if not any(one.get("name") for one in element.all("actuator")):
        if any(one.get("name") is None for one in element.all("actuator")):
            say(LogLevel.ERROR, "No name attribute specified for actuator.")
        say(LogLevel.ERROR, f"Failed to load actuators for transmission '{name}'.")
        return None
    if len(joints) > 1:
        say(
            LogLevel.WARN,
            f"Transmission {name} has more than one joint. Currently the default robot hardware "
            "simulation  interface only supports one.",
        )
        return None
    return _transmission(name, *joints[0], say)


def _joints(element: Element, say: Say) -> list[tuple[str, list[str]]]:
    """The joints of a transmission that have an interface, with the interfaces."""
    joints = []
    for joint in element.all("joint"):
        name = joint.get("name")
        if name is None:
            say(LogLevel.ERROR, "No name attribute specified for joint.")
            return []
        texts = [one.text.strip() for one in joint.all("hardwareInterface")]
        interfaces = [text for text in texts if text]
        if not name:
            say(LogLevel.ERROR, "Empty name attribute specified for joint.")
        elif not interfaces:
            say(LogLevel.ERROR, f"No valid hardware interface element found in joint '{name}'.")
        else:
            joints.append((name, interfaces))
    return joints


def _advise(element: Element, say: Say) -> None:
    if any(one.child("hardwareInterface") for one in element.all("actuator")):
        say(
            LogLevel.WARN,
            "hint: the <hardwareInterface> of the transmission stands in its <actuator>; "
            "it must stand in its <joint>",
        )


def _transmission(name: str, joint: str, interfaces: list[str], say: Say) -> Transmission | None:
    if len(interfaces) > 1:
        say(
            LogLevel.WARN,
            f"Joint {joint} of transmission {name} specifies multiple hardware interfaces. Currently "
            "the default robot hardware simulation interface only supports one. Using the first entry",
        )
    text = interfaces[0]
    bare = text.removeprefix(PREFIX)
    if bare not in INTERFACES:
        say(
            LogLevel.FATAL,
            f"No matching hardware interface found for '{text}' while loading interfaces for {joint}",
        )
        say(
            LogLevel.WARN,
            f"hint: the joint {joint} is not controlled; write one of: "
            + ", ".join(PREFIX + one for one in INTERFACES),
        )
        return None
    if bare == text:
        say(
            LogLevel.WARN,
            f"Deprecated syntax, please prepend 'hardware_interface/' to '{text}' within the "
            f"<hardwareInterface> tag in joint '{joint}'.",
        )
    return Transmission(joint=joint, interface=bare)
