"""ros_control: transmissions, controllers, lists of joints, gains."""

from __future__ import annotations

import pytest

from simkit.diagnostics import Severity

ROBOT = """<link name="base"/><link name="torso"/><link name="arm"/><link name="tip"/>
<joint name="hip" type="continuous"><parent link="base"/><child link="torso"/><axis xyz="0 0 1"/></joint>
<joint name="shoulder" type="continuous"><parent link="torso"/><child link="arm"/><axis xyz="0 1 0"/></joint>
<joint name="stiff" type="fixed"><parent link="arm"/><child link="tip"/></joint>
"""
POSITION = "hardware_interface/PositionJointInterface"
CONTROL = '<gazebo><plugin name="control" filename="libgazebo_ros_control.so"/></gazebo>\n'
STATES = """<gazebo><plugin name="s" filename="libgazebo_ros_joint_state_publisher.so">
<jointName>{}</jointName></plugin></gazebo>"""


def transmission(joint, interface=POSITION, number=0):
    """Five lines: the joint on the third, the interface on the fourth."""
    return f"""<transmission name="tran{number}">
<type>transmission_interface/SimpleTransmission</type>
<joint name="{joint}">
<hardwareInterface>{interface}</hardwareInterface></joint>
<actuator name="motor{number}"><mechanicalReduction>1</mechanicalReduction></actuator></transmission>
"""


BOTH = transmission("hip") + transmission("shoulder", number=1)
ARM = """arm_controller:
  type: "position_controllers/JointTrajectoryController"
  joints:
    - hip
    - shoulder
"""


def test_a_robot_whose_three_places_agree(told):
    found = told(ROBOT + CONTROL + BOTH, yaml=ARM)
    assert [one for one in found if one.rule in ("CTL-E01", "CTL-E02")] == []


@pytest.mark.parametrize(
    ("right", "wrong", "line", "what", "remedy"),
    [
        ('"hip"', '"hipp"', 9, "for 'hipp', and there is no such joint", "'hip'"),
        ('"hip"', '"stiff"', 9, "for 'stiff', a fixed joint", "Leave out the transmission"),
        (
            f"\n<hardwareInterface>{POSITION}</hardwareInterface>",
            "",
            9,
            "'hip' of the transmission has no <hardwareInterface>",
            POSITION,
        ),
        (
            POSITION,
            "hardware_interface/PositionJointInterfase",
            10,
            "no hardware interface",
            f"'{POSITION}'",
        ),
        (POSITION, "magic", 10, "no hardware interface 'magic'", POSITION),
        (' name="tran0"', "", 7, 'lacks the attribute name="..."', "name"),
        (
            "<type>transmission_interface/SimpleTransmission</type>",
            "",
            7,
            "'tran0' lacks <type>",
            "SimpleTransmission",
        ),
        (
            '<actuator name="motor0"><mechanicalReduction>1</mechanicalReduction></actuator>',
            "",
            7,
            "lacks <actuator",
            "<actuator",
        ),
    ],
)
def test_transmissions_that_are_skipped(told, right, wrong, line, what, remedy):
    one_of_them = transmission("hip")
    assert right in one_of_them
    text = ROBOT + CONTROL + one_of_them.replace(right, wrong)
    (one,) = told(text, "CTL-E01")
    assert (one.severity, one.span.line) == (Severity.ERROR, line)
    assert what in one.what
    assert remedy in one.remedy
    (one,) = told(text.replace(CONTROL, ""), "CTL-E01")
    assert one.severity is Severity.WARNING  # nothing here reads it; a real robot may


def test_an_interface_only_in_the_actuator(told):
    moved = transmission("hip").replace(f"<hardwareInterface>{POSITION}</hardwareInterface>", "")
    moved = moved.replace(
        "<mechanicalR", f"<hardwareInterface>{POSITION}</hardwareInterface><mechanicalR"
    )
    (one,) = told(ROBOT + CONTROL + moved, "CTL-E01")
    assert "it stands only in the <actuator>" in one.what


def test_old_names_of_interfaces_and_misspelt_types_are_worth_a_note(told):
    (one,) = told(ROBOT + CONTROL + transmission("hip", "PositionJointInterface"), "CTL-E01")
    assert (one.severity, one.remedy) == (Severity.NOTE, f"Write {POSITION}.")
    wrong = transmission("hip").replace("SimpleTransmission", "SimpelTransmission")
    (one,) = told(ROBOT + CONTROL + wrong, "CTL-E01")
    assert one.severity is Severity.NOTE


def test_transmissions_and_plugin_need_each_other(told):
    (one,) = told(ROBOT + BOTH, "CTL-E02")
    assert (one.severity, one.span.line) == (Severity.NOTE, 6)
    (one,) = told(ROBOT + BOTH + "<gazebo/>", "CTL-E02")
    assert one.severity is Severity.WARNING
    mended = one.remedy[one.remedy.index("<gazebo>") : one.remedy.index("</gazebo>") + 9]
    assert told(ROBOT + BOTH + mended, "CTL-E02") == []
    (one,) = told(ROBOT + CONTROL, "CTL-E02")
    assert "'hip', 'shoulder'" in one.remedy


@pytest.mark.parametrize(
    ("right", "wrong", "line", "what", "remedy"),
    [
        ("- shoulder", "- sholder", 5, "moves 'sholder', and there is no such joint", "'shoulder'"),
        ("- shoulder", "- stiff", 5, "no transmission offers 'stiff'", "PositionJointInterface"),
        (
            "position_controllers",
            "effort_controllers",
            4,
            "needs EffortJointInterface, and the transmission of 'hip' offers 'PositionJointInterface'",
            "position_controllers/JointTrajectoryController",
        ),
        (
            "JointTrajectory",
            "JointTrajektory",
            2,
            "no controller of type",
            "'position_controllers/JointTrajectoryController'",
        ),
        (
            '  type: "position_controllers/JointTrajectoryController"\n',
            "",
            1,
            "'arm_controller' has no type",
            "Add type:",
        ),
        (
            "  joints:\n    - hip\n    - shoulder\n",
            "",
            1,
            "names no joints",
            "Add joints: [hip, shoulder]",
        ),
        ("    - hip", "\t- hip", 4, "the file is no YAML", "not with tabs"),
    ],
)
def test_controllers_that_do_not_fit(told, right, wrong, line, what, remedy):
    assert right in ARM
    one = told(ROBOT + CONTROL + BOTH, "CTL-E01", yaml=ARM.replace(right, wrong))[0]
    assert (one.file, one.severity, one.span.line) == ("controllers.yaml", Severity.ERROR, line)
    assert what in one.what
    assert remedy in one.remedy
    assert one.source == ARM.replace(right, wrong).splitlines()[line - 1]


@pytest.mark.parametrize(
    "yaml",
    [
        "robot:\n  joint_state_controller:\n    type: joint_state_controller/JointStateController\n    publish_rate: 50\n",
        "robot:\n  " + ARM.replace("\n", "\n  "),
        "hip_controller:\n  type: position_controllers/JointPositionController\n  joint: hip\n",
        "use_sim_time: true\nnames: [1, 2]\n",
        "",
        "a: &a [*a]\n",
    ],
    ids=["joint states", "in a namespace", "one joint", "no controllers", "empty", "a loop"],
)
def test_files_that_fit(told, yaml):
    assert told(ROBOT + CONTROL + BOTH, "CTL-E01", yaml=yaml) == []


def test_a_controller_of_another_package_is_only_worth_a_note(told):
    yaml = ARM.replace("position_controllers/JointTrajectoryController", "my_package/MyController")
    (one,) = told(ROBOT + CONTROL + BOTH, "CTL-E01", yaml=yaml)
    assert one.severity is Severity.NOTE


def test_gains(told):
    effort = transmission("hip", "hardware_interface/EffortJointInterface")
    yaml = "hip_controller:\n  type: effort_controllers/JointPositionController\n  joint: hip\n"
    (one,) = told(ROBOT + CONTROL + effort, "CTL-I03", yaml=yaml)
    assert (one.severity, one.span.line) == (Severity.WARNING, 1)
    assert "Add pid: {p: 100.0" in one.remedy
    assert (
        told(ROBOT + CONTROL + effort, "CTL-I03", yaml=yaml + "  pid: {p: 1, i: 0, d: 0}\n") == []
    )
    (one,) = told(ROBOT + CONTROL + BOTH, "CTL-I03", yaml=ARM)
    assert one.severity is Severity.NOTE
    assert "Harmless" in one.gazebo
    assert (
        told(ROBOT + CONTROL + effort, "CTL-I03", yaml=yaml.replace("JointPosition", "JointEffort"))
        == []
    )


@pytest.mark.parametrize(
    ("names", "severity", "what", "remedy"),
    [
        ("hip", Severity.WARNING, "lacks 'shoulder'", "<jointName>hip, shoulder</jointName>"),
        (
            "hip, sholder",
            Severity.ERROR,
            "names 'sholder', and there is no such joint",
            "'shoulder'",
        ),
        ("hip, shoulder, stiff", Severity.ERROR, "'stiff', which is fixed", "'hip', 'shoulder'"),
        ("hip,\n shoulder", Severity.ERROR, "a line break or tab", "hip, shoulder"),
        ("hip, shoulder,", Severity.ERROR, "has an empty name", "comma"),
    ],
)
def test_lists_of_joints_that_do_not_fit(told, names, severity, what, remedy):
    one = told(ROBOT + STATES.format(names), "CTL-W06")[0]
    assert (one.severity, one.span.line) == (severity, 7)
    assert what in one.what
    assert remedy in one.remedy


@pytest.mark.parametrize(
    "names", ["hip, shoulder", "hip,shoulder", " shoulder ,  hip ", "\nhip, shoulder\n"]
)
def test_lists_of_joints_that_fit(told, names):
    assert told(ROBOT + STATES.format(names), "CTL-W06") == []


def test_joints_that_follow_others_need_not_be_listed(told):
    mimic = ROBOT.replace('<axis xyz="0 1 0"/>', '<axis xyz="0 1 0"/><mimic joint="hip"/>')
    assert told(mimic + STATES.format("hip"), "CTL-W06") == []
