"""yourdfpy as an oracle: over all robots it finds the same tree, limits, scales and poses."""

from __future__ import annotations

import random
from pathlib import Path

import numpy as np
import pytest

from simkit.packages import PackagePath
from simkit.urdf import load_robot
from simkit.urdf.kinematics import forward_kinematics

ROBOTS = Path(__file__).resolve().parents[3] / "robots"
FILES = sorted(ROBOTS.glob("*/urdf/*.urdf"))
CORNER = """<robot name="r"><link name="a"><visual><geometry>
<mesh filename="package://meshes/corner.stl" scale="1 2 -3"/></geometry></visual></link></robot>"""
FACET = """solid s
facet normal 0 0 1
outer loop
vertex 1 1 1
vertex 2 1 1
vertex 1 2 1
endloop
endfacet
endsolid s
"""


def read(path):
    return load_robot(path.read_text(), file=path.name, packages=PackagePath([ROBOTS]))


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_both_read_the_same_tree_and_limits(path):
    ours = read(path)
    theirs = ours.yourdfpy()
    assert theirs.base_link == ours.root
    assert set(theirs.link_map) == set(ours.links)
    assert set(theirs.joint_map) == set(ours.joints)
    for name, joint in theirs.joint_map.items():
        mine = ours.joints[name]
        assert (joint.parent, joint.child, joint.type) == (
            mine.parent,
            mine.child,
            mine.type.value,
        )
        if mine.limit is not None and joint.limit is not None and joint.limit.lower is not None:
            assert (joint.limit.lower, joint.limit.upper) == (mine.limit.lower, mine.limit.upper)


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_both_say_where_the_links_are(path):
    ours, chance = read(path), random.Random(path.stem)
    theirs = ours.yourdfpy()
    positions = {name: chance.uniform(-1.0, 1.0) for name in theirs.actuated_joint_names}
    theirs.update_cfg(positions)
    found = forward_kinematics(ours, positions)
    for link, pose in found.items():
        matrix = theirs.get_transform(link, ours.root)
        assert pose.translation == pytest.approx(matrix[:3, 3], abs=1e-6)
        turned = np.array([pose.rotate(axis) for axis in np.eye(3).tolist()]).T
        assert turned == pytest.approx(matrix[:3, :3], abs=1e-6)


def test_meshes_are_where_packages_are(tmp_path):
    (tmp_path / "meshes").mkdir()
    (tmp_path / "meshes/package.xml").write_text("<package><name>meshes</name></package>")
    (tmp_path / "meshes/corner.stl").write_text(FACET)
    robot = load_robot(CORNER, file="r.urdf", packages=PackagePath([tmp_path]))
    low, high = robot.yourdfpy().scene.bounds
    assert tuple(low) == pytest.approx((1, 2, -3))
    assert tuple(high) == pytest.approx((2, 4, -3))


def test_a_mesh_that_is_not_there_is_left_out():
    robot = load_robot(CORNER, file="r.urdf", packages=PackagePath([]))
    assert robot.yourdfpy().scene.is_empty
