from __future__ import annotations

import math
import re

import pytest

ROBOT = """<?xml version="1.0"?>
<robot name="hello_ros_robot">
  <link name="world"/>
  <link name="base_link"/>
  <link name="torso">
    <visual>
      <geometry><cylinder length="0.5" radius="0.05"/></geometry>
      <origin xyz="0 0 0.25"/>
    </visual>
  </link>
  <link name="upper_arm">
    <visual>
      <geometry><cylinder length="0.4" radius="0.05"/></geometry>
      <origin xyz="0 0 0.2"/>
    </visual>
  </link>
  <joint name="fixed" type="fixed">
    <parent link="world"/>
    <child link="base_link"/>
  </joint>
  <joint name="hip" type="continuous">
    <axis xyz="0 0 1"/>
    <parent link="base_link"/>
    <child link="torso"/>
    <origin rpy="0 0 0" xyz="0.0 0.0 0.05"/>
  </joint>
  <joint name="shoulder" type="continuous">
    <axis xyz="0 1 0"/>
    <parent link="torso"/>
    <child link="upper_arm"/>
    <origin rpy="0 1.5708 0" xyz="0.0 -0.1 0.45"/>
  </joint>
</robot>
"""
LAUNCH = """<launch>
  <param name="robot_description" textfile="$(find hello_ros)/urdf/robot.urdf"/>
  <param name="use_gui" value="true"/>
  <node name="joint_state_publisher" pkg="joint_state_publisher" type="joint_state_publisher"/>
  <node name="robot_state_publisher" pkg="robot_state_publisher" type="robot_state_publisher"/>
</launch>
"""
BEGIN = "%load_ext simkit\nfrom simkit import Simulation\nsim = Simulation(screen=None)"
START = "%roslaunch hello_ros arm.launch"
WHERE = "print(*sim.latest('/joint_states').position)"
TIP = (
    "tip = sim.tf.lookup_transform('world', 'upper_arm').transform.translation\n"
    "print(tip.x, tip.y, tip.z)"
)
LONG = "import time\nfor _ in range(40):\n    sim.run(1.0)\n    time.sleep(0.05)\nprint('done')"
SLIDER = ".simkit-sliders input[type=range]"
HANDLES = f"document.querySelectorAll('{SLIDER}').length"
READ = "[...document.querySelectorAll('.simkit-sliders .joint input[type=number]')].map((one) => one.value)"


def numbers(text):
    return [float(number) for number in re.findall(r"-?\d+\.\d+(?:e-?\d+)?", text)]


@pytest.fixture
def sliders(lab):
    """The robot of exercise 3.8 with its two sliders, and cells to ask it."""
    lab.write("hello_ros/package.xml", "<package><name>hello_ros</name></package>")
    lab.write("hello_ros/urdf/robot.urdf", ROBOT)
    lab.write("hello_ros/launch/arm.launch", LAUNCH)
    lab.open(BEGIN, START, WHERE, LONG, TIP)
    lab.run_cell(0)
    lab.run_cell(1)
    lab.page.wait(f"{HANDLES} === 2")
    return lab


def asked(lab, cell):
    lab.run_cell(cell)
    return numbers(lab.output(cell))


def shown(lab):
    """What stands beside the sliders."""
    return [float(text) for text in lab.page.run(READ)]


def test_sliders_move_the_robot(sliders):
    page = sliders.page
    assert "Node: /joint_state_publisher" in sliders.output(1)
    page.screenshot("sliders_at_zero")
    page.drag(SLIDER, 0, 50)
    page.drag(SLIDER, 1, -30)
    page.screenshot("sliders_moved")
    hip, shoulder = asked(sliders, 2)
    assert hip > 0.5
    assert shoulder < -0.3
    # The shoulder sits 0.1 m beside the axis of the hip.
    x, y = 0.1 * math.sin(hip), -0.1 * math.cos(hip)
    assert asked(sliders, 4) == pytest.approx([x, y, 0.5], abs=1e-9)
    assert shown(sliders) == pytest.approx([hip, shoulder], abs=6e-4)
    page.run(
        "[...document.querySelectorAll('button')].find((b) => b.innerText === 'Center').click()"
    )
    page.wait(f"{READ}.every((text) => text === '0.000')")
    assert asked(sliders, 2) == [0.0, 0.0]


def test_the_robot_is_beside_the_sliders_or_above_them_in_a_narrow_cell(sliders):
    page = sliders.page
    frame = "document.querySelector('.jp-OutputArea-output iframe[sandbox]')"
    page.wait(f"!!{frame}")
    page.drag(SLIDER, 1, -40)
    places = f"[{frame}, document.querySelector('{SLIDER}')].map((one) => one.getBoundingClientRect().toJSON())"
    for width, is_narrow in ((1700, False), (900, True)):
        size = {"width": width, "height": 1000, "deviceScaleFactor": 1, "mobile": False}
        page.call("Emulation.setDeviceMetricsOverride", **size)
        page.wait(f"window.innerWidth === {width}")
        picture, slider = page.run(f"new Promise((go) => setTimeout(() => go({places}), 500))")
        page.screenshot(f"sliders_at_{width}")
        if is_narrow:
            assert slider["top"] > picture["bottom"]
            assert abs(slider["left"] - picture["left"]) < picture["width"] / 2
        else:
            assert picture["left"] > slider["right"]
            assert picture["width"] > 500
    # No other port than that of JupyterLab.
    ports = "new Set(performance.getEntriesByType('resource').map((one) => new URL(one.name).port).filter(Boolean)).size"
    assert page.run(ports) == 1


def test_an_arrow_key_moves_a_slider_by_a_thousandth(sliders):
    page = sliders.page
    page.run(f"document.querySelector('{SLIDER}').focus()")
    for kind in ("rawKeyDown", "keyUp"):
        page.call("Input.dispatchKeyEvent", type=kind, key="ArrowRight", code="ArrowRight")
    page.wait(f"{READ}[0] === '0.006'")
    assert asked(sliders, 2)[0] == pytest.approx(math.tau / 1000)


def test_a_still_for_the_saved_notebook_waits_behind_the_sliders(sliders):
    page = sliders.page
    page.drag(SLIDER, 0, 50)
    (hip, _) = asked(sliders, 2)
    page.wait(f"document.querySelector('.simkit-still').textContent.includes('{hip:.3f} rad')")
    seen = "[...document.querySelectorAll('.simkit-still, #panel')].map((one) => one.checkVisibility())"
    page.run(
        "document.querySelector('.jp-OutputArea-output.lm-Panel:has(.simkit-panel)').id = 'panel'"
    )
    assert page.run(seen) == [True, False]
    # What JupyterLab makes of widgets that no kernel knows.
    page.run("document.getElementById('panel').replaceChildren('Error displaying widget')")
    assert page.run(seen) == [False, True]
    page.screenshot("sliders_without_a_kernel")


def test_a_slider_can_be_moved_while_a_cell_runs(sliders):
    page = sliders.page
    sliders.start_cell(3)
    page.drag(SLIDER, 0, 50)
    page.run("running.then(() => true)")
    assert sliders.output(3).strip() == "done"
    # While the kernel is busy, Jupyter keeps the latest value back; it comes when the cell has ended.
    hips = (asked(sliders, 2)[0] for _ in range(100))
    assert any(hip > 0.5 for hip in hips)
