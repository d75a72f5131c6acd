"""Sliders of a trajectory controller in a real JupyterLab: the arm of exercise 3.10 goes where they are put."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

ROBOTS = Path(__file__).resolve().parents[2] / "robots"
BEGIN = (
    "from simkit import Simulation\nsim = Simulation(screen=None)\n"
    "sim.roslaunch('hello_ros', 'spawn_gazebo_2.launch')\nsim.run(5.0)"
)
SHOW = "sliders = sim.trajectory_sliders('/arm_controller', duration=0.5)\nsliders"
WHERE = "print(*sim.latest('/joint_states').position)"
SLIDER = ".simkit-sliders input[type=range]"
HANDLES = f"document.querySelectorAll('{SLIDER}').length"


def where(lab):
    lab.run_cell(2)
    return [float(number) for number in re.findall(r"-?\d+\.\d+(?:e-?\d+)?", lab.output(2))]


def test_an_arm_goes_where_its_sliders_are_put(lab):
    for file in sorted(path for path in (ROBOTS / "hello_ros").rglob("*") if path.is_file()):
        lab.write(str(file.relative_to(ROBOTS)), file.read_text(encoding="utf-8"))
    lab.open(BEGIN, SHOW, WHERE)
    lab.run_cell(0)
    lab.run_cell(1)
    page = lab.page
    page.wait(f"{HANDLES} === 2")
    assert where(lab) == pytest.approx([0.0, 0.0], abs=1e-6)  # to look at it does not move it
    page.drag(SLIDER, 0, 40)
    page.drag(SLIDER, 1, -25)
    page.wait("document.body.innerText.split('is at -').length > 1")
    page.screenshot("trajectory_sliders")
    hip, shoulder = where(lab)
    assert hip > 0.5
    assert shoulder < -0.3
