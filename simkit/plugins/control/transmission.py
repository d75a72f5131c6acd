"""Transmissions: which joints of a robot have a motor, and what it can be told.

Source: transmission_interface `transmission_parser.cpp`, texts and order; `DefaultRobotHWSim::initSim`.
"""

from __future__ import annotations

from dataclasses import dataclass

from simkit.graph import LogLevel
from simkit.plugins.control.interfaces import INTERFACES, PREFIX
from simkit.xml import Element


@dataclass(frozen=True, slots=True, kw_only=True)
class Complaint:
    """Something that is said of a transmission."""

    level: LogLevel
    """How bad it is."""
    text: str
    """What is said."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Transmission:
    """A joint with a motor."""

    joint: str
    """Name of the joint."""
    interface: str
    """What the motor can be told, without prefix: `PositionJointInterface`."""


def read_transmissions(robot: Element) -> tuple[list[Transmission], list[Complaint]]:
    """The transmissions of a URDF that the simulation can use, and what is said of all others.

    Args:
        robot: The root element.
    """
    found: list[Transmission] = []
    complaints: list[Complaint] = []
    for element in robot.all("transmission"):
        said = _Said()
        transmission = _read(element, said)
        complaints += said.complaints
        if transmission is not None:
            found.append(transmission)
    return found, complaints


class _Said:
    """Collects what is said."""

    def __init__(self) -> None:
        self.complaints: list[Complaint] = []

    def error(self, text: str) -> None:
        self.complaints.append(Complaint(level=LogLevel.ERROR, text=text))

    def warn(self, text: str) -> None:
        self.complaints.append(Complaint(level=LogLevel.WARN, text=text))

    def fatal(self, text: str) -> None:
        self.complaints.append(Complaint(level=LogLevel.FATAL, text=text))


def _read(element: Element, said: _Said) -> Transmission | None:
    name = element.get("name")
    if not name:
        how = "No name attribute" if name is None else "Empty name attribute"
        said.error(f"{how} specified for transmission.")
        return None
    kind = element.child("type")
    if kind is None:
        said.error(f"No type element found in transmission '{name}'.")
        return None
    if not kind.text.strip():
        said.error(f"Skipping empty type element in transmission '{name}'.")
        return None
    joints = _joints(element, said)
    if not joints:
        said.error(f"Failed to load joints for transmission '{name}'.")
        _advise(element, said)
        return None
    if not any(one.get("name") for one in element.all("actuator")):
        if any(one.get("name") is None for one in element.all("actuator")):
            said.error("No name attribute specified for actuator.")
        said.error(f"Failed to load actuators for transmission '{name}'.")
        return None
    if len(joints) > 1:
        said.warn(
            f"Transmission {name} has more than one joint. Currently the default robot hardware "
            "simulation  interface only supports one."
        )
        return None
    return _transmission(name, *joints[0], said)


def _joints(element: Element, said: _Said) -> list[tuple[str, list[str]]]:
    """The joints of a transmission that have an interface, with the interfaces."""
    joints = []
    for joint in element.all("joint"):
        name = joint.get("name")
        if name is None:
            said.error("No name attribute specified for joint.")
            return []
        texts = [one.text.strip() for one in joint.all("hardwareInterface")]
        interfaces = [text for text in texts if text]
        if not name:
            said.error("Empty name attribute specified for joint.")
        elif not interfaces:
            said.error(f"No valid hardware interface element found in joint '{name}'.")
        else:
            joints.append((name, interfaces))
    return joints


def _advise(element: Element, said: _Said) -> None:
    if any(one.child("hardwareInterface") for one in element.all("actuator")):
        said.warn(
            "hint: the <hardwareInterface> of the transmission stands in its <actuator>; "
            "it must stand in its <joint>"
        )


def _transmission(name: str, joint: str, interfaces: list[str], said: _Said) -> Transmission | None:
    if len(interfaces) > 1:
        said.warn(
            f"Joint {joint} of transmission {name} specifies multiple hardware interfaces. Currently "
            "the default robot hardware simulation interface only supports one. Using the first entry"
        )
    text = interfaces[0]
    bare = text.removeprefix(PREFIX)
    if bare not in INTERFACES:
        said.fatal(
            f"No matching hardware interface found for '{text}' while loading interfaces for {joint}"
        )
        said.warn(
            f"hint: the joint {joint} is not controlled; write one of: "
            + ", ".join(PREFIX + one for one in INTERFACES)
        )
        return None
    if bare == text:
        said.warn(
            f"Deprecated syntax, please prepend 'hardware_interface/' to '{text}' within the "
            f"<hardwareInterface> tag in joint '{joint}'."
        )
    return Transmission(joint=joint, interface=bare)
