from __future__ import annotations

import pytest

from simkit.viz.solid import Role
from simkit.viz.world.settings import WorldSettings


def test_at_first_one_sees_the_models_on_the_ground():
    displays = WorldSettings().displays
    assert [role for role in Role if displays.shows(role)] == [Role.VISUAL, Role.GROUND]
    assert (displays.grid, displays.tf, displays.transparent) == (True, False, False)


@pytest.mark.parametrize(
    ("name", "role"),
    [
        ("collisions", Role.COLLISION),
        ("center_of_mass", Role.CENTRE),
        ("inertias", Role.INERTIA),
        ("joints", Role.JOINT),
    ],
)
def test_each_display_of_the_menu_shows_its_shapes(name, role):
    assert WorldSettings(**{name: True}).displays.shows(role)


@pytest.mark.parametrize("name", ["center_of_mass", "inertias", "joints"])
def test_one_sees_through_models_when_something_inside_is_shown(name):
    assert WorldSettings(**{name: True}).displays.transparent is True
    assert WorldSettings(**{name: True}, transparent=False).displays.transparent is False


def test_models_can_be_left_out():
    assert not WorldSettings(models=False).displays.shows(Role.VISUAL)
