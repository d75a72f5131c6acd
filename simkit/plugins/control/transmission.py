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

Log: TypeAlias = Callable[[LogLevel, str], None]
"""Logs a fault of a transmission, with its level."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Transmission:
    """A joint with a motor."""

    joint: str
    """Name of the joint."""
    interface: str
    """How the motor is commanded, without prefix: `PositionJointInterface`."""


def read_transmissions(robot: Element, log: Log) -> list[Transmission]:
    """The transmissions of a URDF that the simulation can use.

    Args:
        robot: The root element.
        log: Is given what is wrong with the others.
    """
    found = [_read(element, log) for element in robot.all("transmission")]
    return [one for one in found if one is not None]


def _read(element: Element, log: Log) -> Transmission | None:
    name = element.get("name")
    if not name:
        how = "No name attribute" if name is None else "Empty name attribute"
        log(LogLevel.ERROR, f"{how} specified for transmission.")
        return None
    kind = element.child("type")
    if kind is None:
        log(LogLevel.ERROR, f"No type element found in transmission '{name}'.")
        return None
    if not kind.text.strip():
        log(LogLevel.ERROR, f"Skipping empty type element in transmission '{name}'.")
        return None
    joints = _joints(element, log)
    if not joints:
        log(LogLevel.ERROR, f"Failed to load joints for transmission '{name}'.")
        _advise(element, log)
        return None
    if not any(one.get("name") for one in element.all("actuator")):
        if any(one.get("name") is None for one in element.all("actuator")):
            log(LogLevel.ERROR, "No name attribute specified for actuator.")
        log(LogLevel.ERROR, f"Failed to load actuators for transmission '{name}'.")
        return None
    if len(joints) > 1:
        log(
            LogLevel.WARN,
            f"Transmission {name} has more than one joint. Currently the default robot hardware "
            "simulation  interface only supports one.",
        )
        return None
    return _transmission(name, *joints[0], log)


def _joints(element: Element, log: Log) -> list[tuple[str, list[str]]]:
    """The joints of a transmission that have an interface, with the interfaces."""
    joints = []
    for joint in element.all("joint"):
        name = joint.get("name")
        if name is None:
            log(LogLevel.ERROR, "No name attribute specified for joint.")
            return []
        texts = [one.text.strip() for one in joint.all("hardwareInterface")]
        interfaces = [text for text in texts if text]
        if not name:
            log(LogLevel.ERROR, "Empty name attribute specified for joint.")
        elif not interfaces:
            log(LogLevel.ERROR, f"No valid hardware interface element found in joint '{name}'.")
        else:
            joints.append((name, interfaces))
    return joints


def _advise(element: Element, log: Log) -> None:
    if any(one.child("hardwareInterface") for one in element.all("actuator")):
        log(
            LogLevel.WARN,
            "hint: the <hardwareInterface> of the transmission stands in its <actuator>; "
            "it must stand in its <joint>",
        )


def _transmission(name: str, joint: str, interfaces: list[str], log: Log) -> Transmission | None:
    if len(interfaces) > 1:
        log(
            LogLevel.WARN,
            f"Joint {joint} of transmission {name} specifies multiple hardware interfaces. Currently "
            "the default robot hardware simulation interface only supports one. Using the first entry",
        )
    text = interfaces[0]
    bare = text.removeprefix(PREFIX)
    if bare not in INTERFACES:
        log(
            LogLevel.FATAL,
            f"No matching hardware interface found for '{text}' while loading interfaces for {joint}",
        )
        log(
            LogLevel.WARN,
            f"hint: the joint {joint} is not controlled; write one of: "
            + ", ".join(PREFIX + one for one in INTERFACES),
        )
        return None
    if bare == text:
        log(
            LogLevel.WARN,
            f"Deprecated syntax, please prepend 'hardware_interface/' to '{text}' within the "
            f"<hardwareInterface> tag in joint '{joint}'.",
        )
    return Transmission(joint=joint, interface=bare)
