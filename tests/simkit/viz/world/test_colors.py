from __future__ import annotations

import pytest

from simkit.urdf.rules.vocabulary import COLOURS, PATTERNS
from simkit.viz.world.colors import GREY, gazebo_color


@pytest.mark.parametrize("name", COLOURS)
def test_each_material_that_is_one_colour_has_that_colour(name):
    color, alpha = gazebo_color(f"Gazebo/{name}")
    assert color == (GREY if name in ("Grey", "Gray") else COLOURS[name])
    assert alpha == 1.0


def test_what_is_transparent_or_glows_has_the_colour_of_its_name():
    assert gazebo_color("Gazebo/RedTransparent") == (COLOURS["Red"], 0.5)
    assert gazebo_color("Gazebo/RedTransparentOverlay") == (COLOURS["Red"], 0.5)
    assert gazebo_color("Gazebo/TurquoiseGlowOutline") == (COLOURS["Turquoise"], 1.0)
    assert gazebo_color("Gazebo/BlueLaser") == (COLOURS["Blue"], 1.0)


def test_spaces_and_the_prefix_do_not_matter():
    assert gazebo_color(" Gazebo/Orange\n") == gazebo_color("Orange") == (COLOURS["Orange"], 1.0)


@pytest.mark.parametrize("name", ["", "Gazebo/", "Gazebo/Beige", "Transparent", "Glow"])
def test_an_unknown_material_has_no_colour(name):
    assert gazebo_color(name) is None


def test_every_name_that_the_rules_know_is_taken_without_an_error():
    colors = {name: gazebo_color(f"Gazebo/{name}") for name in PATTERNS}
    assert colors["DarkGray"] == (COLOURS["DarkGrey"], 1.0)
    assert colors["Chrome"] is None
