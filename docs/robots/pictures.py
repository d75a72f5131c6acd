"""Pictures of a robot: as RViz would show it, and the tree of its links and joints."""

from __future__ import annotations

import io
from collections.abc import Mapping
from pathlib import Path

import matplotlib.image
import numpy as np
from facts import RobotFacts

from simkit import Simulation
from simkit.viz import RobotTree

GROUND = "odom"
"""The frame on the ground, below robots that move about; those of the book call it so."""
_SECONDS = 0.5
_OPACITY = 0.75
_LEVELS, _SHARE = 0.04, 0.002
"Two pictures are the same if at most this share of their numbers differs by more than these levels."


def photograph(facts: RobotFacts, positions: Mapping[str, float], *, packages: Path) -> bytes:
    """A PNG of the robot among its frames; a body on wheels is seen through, for what is below it.

    Args:
        facts: The robot.
        positions: Of its joints by name [rad]; others are at 0.
        packages: Folder of the packages.
    """
    with Simulation(package_path=[packages], screen=None) as sim:
        sim.params.set("/robot_description", facts.path.read_text(encoding="utf-8"))
        for joint, position in positions.items():
            sim.params.set(f"/joint_state_publisher/zeros/{joint}", position)
        for node in ("joint_state_publisher", "robot_state_publisher"):
            sim.rosrun(node, node)
        fixed, opacity = facts.robot.root, 1.0
        if fixed != "world":
            fixed, opacity, height = GROUND, _OPACITY, f"{-facts.low[2]:g}"
            pose = ("0", "0", height, "0", "0", "0", GROUND, facts.robot.root)
            sim.rosrun("tf2_ros", "static_transform_publisher", *pose)
        sim.run(_SECONDS)
        view = sim.rviz(fixed_frame=fixed, alpha=opacity)
        if view.problems:
            raise SystemExit(f"{facts.path}: {'; '.join(view.problems)}")
        return view.to_png(scale=1)


def tree(facts: RobotFacts) -> bytes:
    """An SVG of its links and joints."""
    return RobotTree(facts.robot).to_svg().encode()


def is_same(path: Path, new: bytes) -> bool:
    """Whether a picture is there already; a PNG may differ as much as other processors make it differ."""
    if not path.is_file():
        return False
    old = path.read_bytes()
    if old == new or path.suffix != ".png":
        return old == new
    before, after = (matplotlib.image.imread(io.BytesIO(data)) for data in (old, new))
    if before.shape != after.shape:
        return False
    return bool(np.mean(np.abs(before - after) > _LEVELS) < _SHARE)
