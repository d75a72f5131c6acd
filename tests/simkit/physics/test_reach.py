"""No shape ever leaves its region, whatever the joints do."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from simkit.geometry import Transform
from simkit.physics import World, plan_robot
from simkit.physics.reach import Region, reaches
from simkit.urdf import load_robot

angles = st.floats(-math.pi, math.pi)
lengths = st.floats(-0.5, 0.5)
places = st.tuples(lengths, lengths, lengths)
turns = st.tuples(angles, angles, angles)
kinds = st.sampled_from(["fixed", "continuous", "prismatic"])
axes = st.sampled_from(["1 0 0", "0 1 0", "0 0 1", "0.6 0 0.8"])
solids = st.sampled_from(
    [
        '<box size="0.1 0.2 0.3"/>',
        '<cylinder radius="0.05" length="0.4"/>',
        '<sphere radius="0.1"/>',
    ]
)
links = st.lists(st.tuples(kinds, axes, places, turns, solids, places), min_size=1, max_size=5)


def chain(parts) -> str:
    """A chain of links that hangs on the world."""
    text = ['<robot name="chain"><link name="world"/>']
    parent = "world"
    for number, (kind, axis, place, turn, solid, middle) in enumerate(parts):
        text.append(
            f'<link name="l{number}"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/>'
            f'</inertial><collision><origin xyz="{_words(middle)}"/><geometry>{solid}</geometry></collision></link>'
            f'<joint name="j{number}" type="{kind}"><parent link="{parent}"/><child link="l{number}"/>'
            f'<origin xyz="{_words(place)}" rpy="{_words(turn)}"/><axis xyz="{axis}"/>'
            '<limit lower="-0.3" upper="0.2" effort="1" velocity="1"/></joint>'
        )
        parent = f"l{number}"
    return "".join([*text, "</robot>"])


def _words(numbers) -> str:
    return " ".join(f"{number:.4f}" for number in numbers)


def inside(region: Region, point, radius: float) -> bool:
    """Whether a ball is in a region."""
    away = np.subtract(point, region.centre)
    along = float(away @ region.axis)
    across = float(np.linalg.norm(away - along * np.array(region.axis)))
    off = math.hypot(along, across - region.ring) if region.ring else float(np.linalg.norm(away))
    return off + radius <= region.radius + 1e-6


@settings(max_examples=60, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(links, places, st.randoms(use_true_random=False))
def test_shapes_stay_in_their_regions(parts, place, random):
    world = World(ground=False)
    base = Transform(place, (0.0, 0.6, 0.0, 0.8))
    model = world.add(plan_robot(load_robot(chain(parts), file="chain.urdf")), pose=base)
    found = {
        f"chain::{body}::{number}": reach for body, number, reach in reaches(model.plan, model.base)
    }
    for _ in range(10):
        for joint in model.joints.values():
            joint.set_position(random.uniform(-3.0, 3.0))
        for label, (node, shape) in model.built.shapes.items():
            size = getattr(shape.solid, "size", None)
            radius = (
                math.hypot(*size) / 2
                if size
                else math.hypot(shape.solid.radius, getattr(shape.solid, "length", 0.0) / 2)
            )
            assert inside(found[label].region, node.getWorldTransform().translation(), radius)


def test_what_cannot_move_is_still_and_what_is_loose_can_be_anywhere(robot_plan):
    arm = {body: reach for body, _, reach in reaches(robot_plan("arm"), HERE)}
    assert [body for body, reach in arm.items() if reach.is_still] == ["base_link"]
    assert all(math.isfinite(reach.region.radius) for reach in arm.values())
    car = [reach for _, _, reach in reaches(robot_plan("car"), HERE)]
    assert all(math.isinf(reach.region.radius) and not reach.is_still for reach in car)


HERE = Transform((0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0))


@pytest.mark.parametrize(
    ("axis", "height"), [((0.0, 0.0, 1.0), 0.8), ((1.0, 0.0, 0.0), 0.3), ((0.6, 0.0, 0.8), 0.5)]
)
def test_how_high_a_circle_is_over_a_plane(axis, height):
    region = Region(centre=(5.0, 0.0, 1.0), axis=axis, ring=0.5, radius=0.2)
    assert region.height_over((0.0, 0.0, 0.0), (0.0, 0.0, 1.0)) == pytest.approx(height)
