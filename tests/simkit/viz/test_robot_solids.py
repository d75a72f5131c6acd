from __future__ import annotations

import pytest

from simkit.urdf import Box, Cylinder, Sphere, load_robot
from simkit.viz.robot_solids import MISSING, TOUCHED, UNPAINTED, robot_shapes
from simkit.viz.solid import Role


def shapes(visual, more="", **options):
    text = f'<robot name="r"><link name="a">{visual}</link>{more}</robot>'
    return robot_shapes(load_robot(text, file="r.urdf"), **options)


def a_visual(geometry, material=""):
    return f"<visual><geometry>{geometry}</geometry>{material}</visual>"


@pytest.mark.parametrize(
    ("geometry", "shape"),
    [
        ('<box size="1 2 3"/>', Box((1.0, 2.0, 3.0))),
        ('<cylinder radius="0.1" length="0.5"/>', Cylinder(0.1, 0.5)),
        ('<sphere radius="2"/>', Sphere(2.0)),
    ],
)
def test_shapes_and_their_place(geometry, shape):
    origin = '<origin xyz="1 2 3" rpy="0 0 3.14159265358979"/>'
    (solid,) = shapes(f"<visual>{origin}<geometry>{geometry}</geometry></visual>").solids
    assert (solid.shape, solid.translation, solid.role) == (shape, (1, 2, 3), Role.VISUAL)
    assert [abs(c) for c in solid.rotation] == pytest.approx((0, 0, 1, 0), abs=1e-9)


def test_colours_are_those_of_the_material_and_red_without_one():
    painted = '<material name="m"><color rgba="0.1 0.2 0.3 0.4"/></material>'
    (solid,) = shapes(a_visual('<sphere radius="1"/>', painted), alpha=0.5).solids
    assert solid.color == (0.1, 0.2, 0.3)
    assert solid.alpha == pytest.approx(0.2)
    (bare,) = shapes(a_visual('<sphere radius="1"/>')).solids
    assert (bare.color, bare.alpha) == (UNPAINTED, 1.0)


def test_a_material_may_be_defined_by_another_link(arm):
    torso = next(s for s in arm.solids if s.link == "torso" and s.role is Role.VISUAL)
    assert torso.color == (0.75, 0.75, 0.75)


def test_collision_shapes_have_a_colour_of_their_own(arm):
    (touched,) = [s for s in arm.solids if s.role is Role.COLLISION]
    assert (touched.link, touched.shape, touched.color) == ("torso", Box((0.1, 0.1, 0.5)), TOUCHED)
    assert touched.alpha < 1


def test_a_box_stands_for_a_mesh_that_is_missing():
    found = shapes(a_visual('<mesh filename="package://nobody/hand.stl"/>'))
    (solid,) = found.solids
    assert solid.shape == Box((0.1, 0.1, 0.1))
    assert solid.color == MISSING
    (note,) = found.notes
    assert note.startswith("A box of 0.1 m stands for the mesh package://nobody/hand.stl of [a]: ")


def test_what_is_beyond_all_measure_is_left_out_and_named():
    found = shapes(a_visual('<sphere radius="1e30"/>') + a_visual('<sphere radius="1"/>'))
    assert [solid.shape for solid in found.solids] == [Sphere(1.0)]
    assert found.notes == ("A shape of [a] is too large or too far away to be drawn.",)


def test_a_robot_of_very_many_shapes_is_drawn_in_part():
    found = shapes(a_visual('<sphere radius="1"/>') * 2100)
    assert len(found.solids) == 2000
    assert found.notes == ("Only the first 2000 of 2100 shapes are drawn.",)
