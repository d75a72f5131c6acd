from __future__ import annotations

import numpy as np
import pytest

from simkit.errors import UnknownNameError
from simkit.viz import LiveWorld, WorldSettings, WorldSource, WorldView
from simkit.viz.still.scene_raster import scene_pixels


def view(sim, **settings):
    return WorldView(WorldSource(sim.gazebo, WorldSettings(**settings)).scene())


def pixels(shown):
    return scene_pixels(shown.scene, size=(360, 225)).astype(int)


def near(image, color, *, by):
    """How many pixels have about a colour, in any light."""
    lit = image[..., :3] / np.maximum(image[..., :3].sum(axis=2, keepdims=True), 1)
    return int((np.abs(lit - np.array(color) / sum(color)).max(axis=2) < by).sum())


def test_it_is_a_page_with_a_checkbox_for_each_display(sim, cart, read_page):
    page = read_page(view(sim).to_html())
    boxes = {a["id"]: "checked" in a for tag, a in page.tags if a.get("type") == "checkbox"}
    assert boxes == {
        "grid": True,
        "tf": False,
        "names": True,
        "visual": True,
        "collision": False,
        "centre": False,
        "inertia": False,
        "joint": False,
        "ground": True,
        "clear": False,
        "marks-contacts": False,
        "marks-scans": True,
    }
    assert "Gazebo" in page.texts
    assert repr(view(sim)) == "WorldView('cart, after 0.10 s')"


@pytest.mark.parametrize(
    ("display", "color"),
    [
        ("collisions", (1.0, 0.44, 0.0)),
        ("contacts", (0x0A, 0x8F, 0x45)),
        ("center_of_mass", (0.85, 0.1, 0.1)),
        ("joints", (0.95, 0.75, 0.0)),
    ],
)
def test_each_display_of_the_menu_is_seen_in_its_colour(sim, cart, display, color):
    settings = {"look_at": "cart", "models": False}
    without, shown = (pixels(view(sim, **settings, **{display: on})) for on in (False, True))
    assert near(shown, color, by=0.03) > near(without, color, by=0.03) + 5


def test_one_sees_inertia_through_transparent_models(sim, cart):
    opaque = pixels(view(sim, look_at="cart"))
    clear = pixels(view(sim, look_at="cart", inertias=True))
    assert (opaque != clear).any(axis=2).sum() > 1000


def test_it_is_saved_as_page_and_picture(sim, cart, tmp_path):
    shown = view(sim)
    shown.save(tmp_path / "world.html")
    assert (tmp_path / "world.html").read_text(encoding="utf-8") == shown.to_html()
    assert shown.to_png(scale=1).startswith(b"\x89PNG")
    with pytest.raises(UnknownNameError, match="picture format"):
        shown.save(tmp_path / "world.gif")


def test_a_live_view_tells_where_links_and_contacts_are_now(sim, cart):
    source = WorldSource(sim.gazebo, WorldSettings(contacts=True), is_live=True)
    live = LiveWorld(source, is_over=lambda: not sim.gazebo.node.alive)
    assert live.url  # starts the server, which sends what has moved
    first = live._live.state
    cart.model.set_pose(cart.model.pose._replace(translation=(0.1, 0.0, 0.3)))
    sim.run(0.001)
    live.refresh()
    state = live._live.state
    assert state.number == first.number
    assert state.poses[0][:3] == pytest.approx(cart.model.pose.translation, abs=1e-6)
    assert first.marks[0].points
    assert not state.marks[0].points
    live.close()
    assert repr(live) == "LiveWorld(ended)"
