from __future__ import annotations

import math

import numpy as np
import pytest

from simkit.geometry import rotate
from simkit.urdf import Box, Cylinder
from simkit.urdf.inertia import shape_tensor
from simkit.viz.stage.parts import Role
from simkit.viz.stage.world_bodies import LEAD, body_solids, inertia_box
from simkit.viz.still.surfaces import rotation_array


def by_role(model, role):
    return [one for one in body_solids(model, name="cart", size=0.3) if one.role is role]


def test_a_ball_of_lead_as_heavy_as_the_body_is_in_its_centre_of_mass(cart):
    base, lid = by_role(cart.model, Role.CENTRE)
    assert (base.link, lid.link) == ("cart::base", "cart::lid")
    assert base.translation == pytest.approx((0.1, 0.0, 0.0))
    assert 4 / 3 * math.pi * base.shape.radius**3 * LEAD == pytest.approx(6.0)


def test_a_box_is_as_hard_to_turn_as_its_body(cart):
    for body in cart.model.plan.bodies.values():
        size, rotation = inertia_box(body)
        turn = rotation_array(rotation)
        tensor = turn @ np.array(shape_tensor(Box(size), body.body.mass)) @ turn.T
        np.testing.assert_allclose(tensor, body.body.tensor, atol=1e-12)


def test_boxes_stand_in_the_centres_of_mass(cart):
    base, _ = by_role(cart.model, Role.INERTIA)
    assert base.translation == pytest.approx((0.1, 0.0, 0.0))


def test_a_joint_that_turns_has_a_rod_and_a_disc_along_its_axis(cart):
    rod, disc = by_role(cart.model, Role.JOINT)
    assert {rod.link, disc.link} == {"cart::lid"}
    for one in (rod, disc):
        assert isinstance(one.shape, Cylinder)
        assert rotate(one.rotation, (0.0, 0.0, 1.0)) == pytest.approx((0.0, 1.0, 0.0))
    assert rod.shape.length == pytest.approx(0.3)
    assert disc.shape.radius > disc.shape.length


def test_what_stands_still_for_ever_shows_nothing_of_this(sim):
    assert list(body_solids(sim.world.model("ground_plane"), name="g", size=1.0)) == []
