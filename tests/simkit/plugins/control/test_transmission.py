"""Transmissions: which are used, and what is said of the others."""

from __future__ import annotations

import pytest

from simkit.graph import LogLevel
from simkit.plugins.control.transmission import Transmission, read_transmissions
from simkit.xml import parse_xml

TYPE = "<type>transmission_interface/SimpleTransmission</type>"
INTERFACE = "<hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>"
JOINT = f'<joint name="hip">{INTERFACE}</joint>'
MOTOR = '<actuator name="m"/>'


def read(inside, name=' name="t"'):
    document = parse_xml(f"<robot><transmission{name}>{inside}</transmission></robot>", file="r")
    said = []
    found = read_transmissions(document.root, lambda level, text: said.append((level.name, text)))
    return found, said


def test_a_joint_has_the_interface_that_stands_in_it():
    assert read(TYPE + JOINT + MOTOR) == (
        [Transmission(joint="hip", interface="EffortJointInterface")],
        [],
    )


def test_neither_reduction_nor_type_matter():
    odd = "<type>Simple</type>" + JOINT
    odd += '<actuator name="m"><mechanicalReduction>50</mechanicalReduction></actuator>'
    assert read(odd) == read(TYPE + JOINT + MOTOR)


@pytest.mark.parametrize(
    ("inside", "name", "said"),
    [
        (TYPE + JOINT + MOTOR, "", "No name attribute specified for transmission."),
        (TYPE + JOINT + MOTOR, ' name=""', "Empty name attribute specified for transmission."),
        (JOINT + MOTOR, ' name="t"', "No type element found in transmission 't'."),
        (
            "<type> </type>" + JOINT + MOTOR,
            ' name="t"',
            "Skipping empty type element in transmission 't'.",
        ),
        (TYPE + MOTOR, ' name="t"', "Failed to load joints for transmission 't'."),
        (TYPE + JOINT, ' name="t"', "Failed to load actuators for transmission 't'."),
    ],
)
def test_one_that_lacks_something_is_skipped(inside, name, said):
    assert read(inside, name) == ([], [("ERROR", said)])


def test_an_interface_in_the_motor_only_is_explained():
    inside = f'{TYPE}<joint name="hip"/><actuator name="m">{INTERFACE}</actuator>'
    found, said = read(inside)
    assert found == []
    assert ("ERROR", "No valid hardware interface element found in joint 'hip'.") in said
    assert any(text.startswith("hint:") and "<actuator>" in text for _, text in said)


def test_an_interface_without_its_prefix_is_taken_and_complained_of():
    bare = INTERFACE.replace("hardware_interface/", "")
    found, said = read(TYPE + f'<joint name="hip">{bare}</joint>' + MOTOR)
    assert found == [Transmission(joint="hip", interface="EffortJointInterface")]
    assert said == [
        (
            "WARN",
            "Deprecated syntax, please prepend 'hardware_interface/' to 'EffortJointInterface' within "
            "the <hardwareInterface> tag in joint 'hip'.",
        )
    ]


def test_an_interface_that_there_is_not_is_refused():
    odd = INTERFACE.replace("Effort", "Torque")
    found, said = read(TYPE + f'<joint name="hip">{odd}</joint>' + MOTOR)
    assert found == []
    assert said[0] == (
        LogLevel.FATAL.name,
        "No matching hardware interface found for 'hardware_interface/TorqueJointInterface' while "
        "loading interfaces for hip",
    )
    assert "hardware_interface/PositionJointInterface" in said[1][1]


def test_of_several_interfaces_the_first_counts():
    second = INTERFACE.replace("Effort", "Position")
    found, said = read(TYPE + f'<joint name="hip">{INTERFACE}{second}</joint>' + MOTOR)
    assert [one.interface for one in found] == ["EffortJointInterface"]
    assert "Using the first entry" in said[0][1]


def test_one_of_several_joints_is_not_used():
    found, said = read(TYPE + JOINT + JOINT.replace("hip", "knee") + MOTOR)
    assert found == []
    assert "more than one joint" in said[0][1]
