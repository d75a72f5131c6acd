"""The teleop pad in a real JupyterLab: buttons by mouse, the arrow keys, time that passes by itself."""

from __future__ import annotations

import re

import pytest

BEGIN = (
    "from simkit import Simulation\nsim = Simulation(screen=None)\n"
    "sim.rosrun('turtlesim', 'turtlesim_node')\nsim.run(0.1)"
)
PAD = "sim.teleop('/turtle1/cmd_vel', linear=2.0, angular=2.0, view=sim.turtlesim)"
WHERE = (
    "pose = sim.latest('/turtle1/pose')\n"
    "print(pose.x, pose.y, pose.theta, sim.now.to_sec() - 1600088400)"
)
KEYBOARD = "document.querySelector('.simkit-teleop-keyboard')"
BUTTON = "document.querySelector('.simkit-teleop-{}')"
STATUS = "document.querySelector('.simkit-teleop').innerText"


@pytest.fixture
def pad(lab):
    lab.open(BEGIN, PAD, WHERE, WHERE)
    lab.run_cell(0)
    lab.run_cell(1)
    lab.page.wait(f"!!{KEYBOARD}")
    return lab


def pose(lab, cell=2):
    lab.run_cell(cell)
    return [float(number) for number in re.findall(r"-?\d+\.\d+(?:e-?\d+)?", lab.output(cell))]


def press(page, key):
    for kind in ("rawKeyDown", "keyUp"):
        page.call("Input.dispatchKeyEvent", type=kind, key=key, code="Space" if key == " " else key)


def test_a_turtle_is_driven_by_mouse_and_by_keys(pad):
    page = pad.page
    x, y, theta, time = pose(pad)
    page.run(BUTTON.format("up") + ".click()")
    page.wait(f"{STATUS}.includes('2 m/s, 0 rad/s')")
    page.screenshot("teleop_driven")
    after_x, after_y, _, after = pose(pad)
    assert after_x - x == pytest.approx(2.0 * (after - time), abs=0.1)
    assert after - time == pytest.approx(0.2)
    assert after_y == pytest.approx(y)

    page.run(f"{KEYBOARD}.focus()")
    press(page, "ArrowLeft")
    page.wait(f"{STATUS}.includes('0 m/s, 2 rad/s')")
    page.screenshot("teleop_by_keys")
    assert page.run(f"document.activeElement === {KEYBOARD}")  # and not another cell
    assert pose(pad)[2] > theta + 0.2
    page.run(f"{KEYBOARD}.focus()")
    press(page, " ")
    page.wait(f"{STATUS}.includes('0 m/s, 0 rad/s')")


def test_a_click_on_a_button_leaves_the_pad_with_the_keys(pad):
    page = pad.page
    assert "Click here to drive" in page.run(STATUS)
    page.click(BUTTON.format("up"))
    page.wait(f"{STATUS}.includes('2 m/s, 0 rad/s')")
    assert "The arrow keys drive" in page.run(STATUS)
    page.screenshot("teleop_has_the_keys")
    for key, command in (("ArrowLeft", "0 m/s, 2 rad/s"), ("ArrowDown", "-2 m/s, 0 rad/s")):
        press(page, key)
        page.wait(f"{STATUS}.includes('{command}')")


def test_time_passes_by_itself_while_run_is_on(pad):
    page = pad.page
    before = pose(pad)[3]
    toggle = "[...document.querySelectorAll('.simkit-teleop button')].find((one) => one.innerText === 'Run')"
    page.run(f"{toggle}.click()")
    page.run(BUTTON.format("up") + ".click()")
    page.wait(f"Number(/time ([\\d.]+) s/.exec({STATUS})[1]) > {1600088400 + before + 1.0}")
    page.run(f"{toggle}.click()")
    page.screenshot("teleop_ran")
    stopped = pose(pad)
    assert stopped[0] > 6.5
    assert pose(pad, 3)[3] == stopped[3]


CAR = """<robot name="car">
  <link name="chassis">
    <inertial><mass value="5"/><inertia ixx="0.1" iyy="0.1" izz="0.1" ixy="0" ixz="0" iyz="0"/></inertial>
    <visual><geometry><box size="0.5 0.3 0.1"/></geometry></visual>
    <collision><geometry><box size="0.5 0.3 0.1"/></geometry></collision>
  </link>
</robot>"""
WORLD = (
    "from simkit import Simulation, msgs\nsim = Simulation(screen=None)\n"
    "sim.params.set('/robot_description', open('car.urdf').read())\n"
    "sim.rosrun('tf', 'static_transform_publisher', *'0 0 0 0 0 0 odom chassis 100'.split())\n"
    "sim.rostopic_pub('/scan', 'sensor_msgs/LaserScan', '{header: {frame_id: chassis}, angle_min: -1, '\n"
    "    'angle_increment: 0.1, range_max: 5, ranges: [1, 1.5, 2, 2.5, 3, 3.5, 4, 4.5]}')\n"
    "sim.run(0.5)\n"
    "view = sim.rviz('odom', topics=['/scan'], live=True)"
)


def test_a_live_view_is_beside_the_pad(lab):
    lab.write("car.urdf", CAR)
    lab.open(WORLD, "sim.teleop(view=view)")
    lab.run_cell(0)
    lab.run_cell(1)
    page = lab.page
    page.wait(f"!!{KEYBOARD}")
    page.wait("!!document.querySelector('.jp-OutputArea iframe')")
    page.run(BUTTON.format("up") + ".click()")
    page.wait(f"{STATUS}.includes('No node listens to /cmd_vel')")
    assert page.screenshot("teleop_with_rviz")
