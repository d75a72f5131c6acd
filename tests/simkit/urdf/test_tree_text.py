from __future__ import annotations

from simkit.urdf import load_robot, tree_text

FINGERS = (
    '<link name="base"/><link name="left"/><link name="right"/>'
    '<joint name="a" type="revolute"><parent link="base"/><child link="left"/><axis xyz="0 -1 0"/>'
    '<origin xyz="0.1 -0.0 0" rpy="0 0 0.3"/>'
    '<limit lower="-0.5" upper="1.2" effort="1" velocity="1"/></joint>'
    '<joint name="b" type="prismatic"><parent link="base"/><child link="right"/>'
    '<axis xyz="0 1 1"/><mimic joint="a"/><limit upper="1e-9" effort="1" velocity="1"/></joint>'
)


def test_the_arm_of_the_book(robots):
    text = (robots / "hello_ros_robot_3.urdf").read_text(encoding="utf-8")
    assert tree_text(load_robot(text, file="r.urdf")) == (
        "hello_ros_robot: 4 links, 3 joints (2 move)\n"
        "world\n"
        "`-- base_link          fixed     fixed\n"
        "    `-- torso          hip       continuous about z  at 0 0 0.05\n"
        "        `-- upper_arm  shoulder  continuous about y  at 0 -0.1 0.45, rpy 0 1.5708 0\n"
    )


def test_branches_limits_and_mimic(robot):
    assert tree_text(robot(FINGERS)) == (
        "r: 3 links, 2 joints (2 move)\n"
        "base\n"
        "|-- left   a  revolute about -y, -0.5 to 1.2                  at 0.1 0 0, rpy 0 0 0.3\n"
        "`-- right  b  prismatic along (0 1 1), 0 to 1e-09, follows a\n"
    )


def test_a_link_alone(robot):
    assert tree_text(robot('<link name="a"/>')) == "r: 1 link, 0 joints (none moves)\na\n"


def test_a_link_that_hangs_on_two_joints_is_spelled_out_once(robot):
    ends = [("j", "a", "b"), ("k", "a", "c"), ("l", "b", "c"), ("m", "c", "d")]
    joints = "".join(
        f'<joint name="{name}" type="fixed"><parent link="{p}"/><child link="{c}"/></joint>'
        for name, p, c in ends
    )
    text = tree_text(robot("".join(f'<link name="{name}"/>' for name in "abcd") + joints))
    assert text.count("(again)") == 1
    assert sum(line.split()[-3:-1] == ["d", "m"] for line in text.splitlines()) == 1
