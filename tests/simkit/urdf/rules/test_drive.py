"""Driven wheels: sides, sizes, torque, casters."""

from __future__ import annotations

import pytest

from simkit.diagnostics import Severity

BODY = """<link name="chassis">
<inertial><mass value="5"/><inertia ixx="0.04" ixy="0" ixz="0" iyy="0.11" iyz="0" izz="0.14"/></inertial>
<collision><geometry><box size="0.5 0.2 0.07"/></geometry></collision></link>
"""


def wheel(name, xyz, *, axis="0 1 0", rpy="0 0 0", radius=0.1, extra=""):
    lying = "1.570796 0 0" if rpy == "0 0 0" else "0 0 0"
    return (
        f'<link name="{name}_wheel"><collision><origin rpy="{lying}"/><geometry><cylinder radius="{radius}" length="0.04"/>'
        f"</geometry></collision></link>\n"
        f'<joint name="{name}" type="continuous"><origin xyz="{xyz}" rpy="{rpy}"/><parent link="chassis"/>'
        f'<child link="{name}_wheel"/><axis xyz="{axis}"/>{extra}</joint>\n'
    )


def diff(*, left="left", right="right", separation="0.3", diameter="0.2", extra=""):
    given = {
        "wheelSeparation": separation,
        "wheelDiameter": diameter,
        "leftJoint": left,
        "rightJoint": right,
    }
    inside = "\n".join(f"<{name}>{value}</{name}>" for name, value in given.items() if value)
    return (
        '<gazebo><plugin name="drive" filename="libgazebo_ros_diff_drive.so">\n'
        f"{inside}{extra}<robotBaseFrame>chassis</robotBaseFrame></plugin></gazebo>\n"
    )


def car(plugin=None, *, body=BODY, left="0 0.15 0", right="0 -0.15 0", **both):
    return (plugin or diff()) + body + wheel("left", left, **both) + wheel("right", right, **both)


DRIVE = ("GZ-W02", "GZ-W03", "GZ-W04", "GZ-W05")


def of_drives(found):
    return [one for one in found if one.rule in DRIVE]


@pytest.mark.parametrize(
    "text",
    [
        car(),
        car(rpy="-1.570796 0 0", axis="0 0 1"),
        car(diff(separation="0.303")),
        car(diff(left="right", right="left"), left="0 -0.15 0", right="0 0.15 0"),
        car(diff(left="left", right="nothing")),
    ],
    ids=[
        "straight",
        "turned joints",
        "rounded",
        "names are only names",
        "a missing joint is told elsewhere",
    ],
)
def test_robots_that_drive_as_they_are_told(told, text):
    assert of_drives(told(text)) == []


@pytest.mark.parametrize(
    ("text", "what", "remedy"),
    [
        (
            car(left="0 -0.15 0", right="0 0.15 0"),
            "the robot turns right",
            "<leftJoint>right</leftJoint>",
        ),
        (car(axis="0 -1 0"), "the robot drives backward", '<axis xyz="0 1 0"/>'),
        (
            car(rpy="1.570796 0 0", axis="0 0 1"),
            "the robot drives backward",
            '<axis xyz="0 0 -1"/>',
        ),
        (
            diff() + BODY + wheel("left", "0 0.15 0") + wheel("right", "0 -0.15 0", axis="0 -1 0"),
            "spins on the spot",
            "the same <axis>",
        ),
        (
            car(axis="1 0 0"),
            "turns about 1 0 0 in 'chassis': it cannot roll forward",
            '<axis xyz="0 1 0"/>',
        ),
        (car(left="0.15 0 0", right="-0.15 0 0"), "not side by side", "Put them apart along y"),
    ],
    ids=[
        "swapped",
        "backward",
        "backward, turned",
        "against each other",
        "about x",
        "one behind the other",
    ],
)
def test_sides(told, text, what, remedy):
    (one,) = told(text, "GZ-W02")
    assert one.severity is Severity.WARNING
    assert what in one.what
    assert remedy in one.remedy
    assert one.source[one.span.column - 1 :].startswith("left")


def test_a_robot_whose_front_is_at_minus_x_is_only_worth_a_note(told):
    (one,) = told(car(left="0 -0.15 0", right="0 0.15 0", axis="0 -1 0"), "GZ-W02")
    assert one.severity is Severity.NOTE


def test_sides_are_those_of_the_base_frame(told):
    turned = (
        '<link name="base"/><joint name="j" type="fixed"><origin rpy="0 0 3.141593"/>'
        '<parent link="base"/><child link="chassis"/></joint>'
    )
    assert told(turned + car(), "GZ-W02") == []
    seen_from_base = diff().replace("<robotBaseFrame>chassis<", "<robotBaseFrame>base<")
    (one,) = told(turned + car(seen_from_base), "GZ-W02")
    assert "front of the robot is at -x" in one.what


@pytest.mark.parametrize(
    ("plugin", "severity", "what", "here", "remedy"),
    [
        (
            diff(separation="0.4"),
            Severity.WARNING,
            "0.4 m, but the wheels are 0.3 m apart",
            "turns 1.333 times",
            "<wheelSeparation>0.3<",
        ),
        (
            diff(separation="0.31"),
            Severity.NOTE,
            "0.31 m",
            "turns 1.033 times",
            "<wheelSeparation>0.3<",
        ),
        (
            diff(separation=""),
            Severity.WARNING,
            "is not given, so 0.34 m",
            "turns 1.133 times",
            "<wheelSeparation>0.3<",
        ),
        (
            diff(diameter="0.1"),
            Severity.WARNING,
            "diameter of 0.2 m (radius 0.1 m)",
            "drives 2 times",
            "<wheelDiameter>0.2<",
        ),
        (
            diff(diameter=""),
            Severity.WARNING,
            "is not given, so 0.15 m",
            "drives 1.333 times",
            "<wheelDiameter>0.2<",
        ),
    ],
)
def test_sizes(told, plugin, severity, what, here, remedy):
    (one,) = told(car(plugin), "GZ-W03")
    assert one.severity is severity
    assert what in one.what
    assert here in one.here
    assert remedy in one.remedy


def test_four_wheels_of_a_skid_steered_robot(told):
    names = {
        "leftFrontJoint": "fl",
        "leftRearJoint": "rl",
        "rightFrontJoint": "fr",
        "rightRearJoint": "rr",
    }
    inside = "".join(f"<{name}>{value}</{name}>" for name, value in names.items())
    places = {"fl": "0.2 0.2 0", "rl": "-0.2 0.2 0", "fr": "0.2 -0.2 0", "rr": "-0.2 -0.2 0"}
    robot = BODY + "".join(wheel(name, xyz) for name, xyz in places.items())
    plugin = (
        '<gazebo><plugin name="d" filename="libgazebo_ros_skid_steer_drive.so">'
        f"{inside}<wheelDiameter>0.2</wheelDiameter><robotBaseFrame>chassis</robotBaseFrame></plugin></gazebo>"
    )
    assert of_drives(told(plugin + robot)) == []
    (one,) = told(plugin + robot.replace(" -0.2 0", " -0.3 0"), "GZ-W03")
    assert "<wheelSeparation> is not given, so 0.4 m, but the wheels are 0.5 m apart" in one.what
    (one,) = told(plugin + robot.replace(' 0.2 0"', ' -0.7 0"'), "GZ-W02")
    assert "the robot turns right" in one.what


def weak(torque, friction=0.0):
    plugin = diff(extra=f"<wheelTorque>{torque}</wheelTorque>" if torque else "")
    return car(plugin, extra=f'<dynamics friction="{friction}"/>')


@pytest.mark.parametrize(
    ("torque", "friction", "words"),
    [
        ("0.1", 0.0, "speeds up the robot of 5 kg by 0.4 m/s² at best"),
        ("1", 1.0, "does not overcome the friction in the joints"),
        ("", 5.0, "a torque of 5 N m at each wheel does not overcome"),
    ],
)
def test_weak_wheels(told, torque, friction, words):
    (one,) = told(weak(torque, friction), "GZ-W04")
    assert one.severity is Severity.WARNING
    assert words in one.what
    mended = one.remedy[one.remedy.index("<wheelTorque>") + 13 : one.remedy.index("</wheelTorque>")]
    assert told(weak(mended, friction), "GZ-W04") == []


def test_a_torque_that_is_not_read_is_no_reason_not_to_move(told):
    (one,) = told(car(diff(extra="<torque>0.1</torque>")), "GZ-W04")
    assert one.severity is Severity.NOTE
    assert one.what.endswith("if it is read")
    assert "5 N m is the default of <wheelTorque>" in one.gazebo


@pytest.mark.parametrize(("torque", "friction"), [("0.2", 0.0), ("", 1.0), ("x", 0.0)])
def test_wheels_that_are_strong_enough(told, torque, friction):
    assert told(weak(torque, friction), "GZ-W04") == []


CASTER = """<link name="caster">
<inertial><mass value="0.1"/><inertia ixx="0.0001" ixy="0" ixz="0" iyy="0.0001" iyz="0" izz="0.0001"/></inertial>
<collision><geometry><sphere radius="0.05"/></geometry></collision></link>
<joint name="caster_joint" type="{}"><origin xyz="0.2 0 -0.05"/><parent link="chassis"/><child link="caster"/></joint>
"""


def test_a_ball_on_a_fixed_joint_drags(told):
    text = car(body=BODY + CASTER.format("fixed"))
    (one,) = told(text, "GZ-W05")
    assert one.severity is Severity.NOTE
    assert one.path == "robot/link[caster]/collision"
    mended = one.remedy[one.remedy.index("<gazebo") : one.remedy.index("</gazebo>") + 9]
    assert told(text + mended, "GZ-W05") == []


@pytest.mark.parametrize(
    "caster",
    [
        CASTER.format("continuous"),
        CASTER.format("fixed").replace("0.2 0 -0.05", "0.2 0 0"),
        CASTER.format("fixed") + '<gazebo reference="caster"><mu1 value="0.1"/></gazebo>',
    ],
    ids=["it rolls", "it does not touch the floor", "it is slippery"],
)
def test_casters_that_do_not_drag(told, caster):
    assert told(car(body=BODY + caster), "GZ-W05") == []
