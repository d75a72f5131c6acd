"""What only a browser can tell of the window of Gazebo: that it draws what its checkboxes say, and plays."""

from __future__ import annotations

import pytest

from simkit.viz import (
    LiveWorld,
    WorldReplay,
    WorldSettings,
    WorldSource,
    WorldTape,
    WorldView,
)

pytestmark = pytest.mark.slow

LOOK = """
await started;
const pixels = () => {
  view.draw();
  const copy = document.createElement("canvas"), picture = element("picture");
  [copy.width, copy.height] = [picture.width, picture.height];
  const paint = copy.getContext("2d");
  paint.drawImage(picture, 0, 0);
  return paint.getImageData(0, 0, copy.width, copy.height).data;
};
// How many pixels have about the colour of a display, in any light.
const near = ([r, g, b]) => {
  const data = pixels(), wanted = r + g + b;
  let count = 0;
  for (let i = 0; i < data.length; i += 4) {
    const sum = data[i] + data[i + 1] + data[i + 2];
    if (data[i + 3] < 60 || sum < 60) continue;
    const off = [r, g, b].map((value, k) => Math.abs(data[i + k] / sum - value / wanted));
    count += Math.max(...off) < 0.04;
  }
  return count;
};
const switched = (name, color) => {
  const counts = [false, true].map((on) => { element(name).checked = on; return near(color); });
  element(name).checked = false;
  return counts;
};
const seek = (time) => { element("time").value = time; element("time").dispatchEvent(new Event("input")); };
"""


def test_each_checkbox_shows_what_it_says(sim, cart, run_in_page):
    shown = WorldView(WorldSource(sim.gazebo, WorldSettings(look_at="cart")).scene())
    found = run_in_page(
        shown.to_html(),
        LOOK
        + """
        for (const name of ["visual", "ground", "grid"]) element(name).checked = false;
        return {
          collision: switched("collision", [1, 0.44, 0]),
          centre: switched("centre", [0.85, 0.1, 0.1]),
          inertia: switched("inertia", [0.62, 0.16, 0.8]),
          joint: switched("joint", [0.95, 0.75, 0]),
          contacts: switched("marks-contacts", [0x0a, 0x8f, 0x45]),
          ground: switched("ground", [1, 1, 1]),
        };
        """,
    )
    for name, (off, on) in found.items():
        assert on > off + 20, name


def test_one_sees_through_the_models_and_again_not(sim, cart, run_in_page):
    shown = WorldView(WorldSource(sim.gazebo, WorldSettings(look_at="cart")).scene())
    counts = run_in_page(
        shown.to_html(),
        LOOK
        + """
        const mint = [0.2, 0.9, 0.6], counts = [near(mint)];
        element("clear").checked = true; counts.push(near(mint));
        element("clear").checked = false; counts.push(near(mint));
        return counts;
        """,
    )
    assert counts[0] == counts[2] > 1000
    assert counts[1] < counts[0] / 2


def test_a_replay_moves_shows_contacts_trails_and_guests_in_their_time(
    sim, cart, cart_text, run_in_page
):
    tape = WorldTape(sim.gazebo, sim.gazebo.node)
    cart.model.set_twist((3.0, 0.0, 0.0), (0.0, 0.0, 0.0))
    sim.run(0.3)
    sim.spawn(cart_text, name="guest", xyz=(0.0, 1.0, 0.05))
    sim.run(0.3)
    sim.gazebo.delete("guest")
    sim.run(0.4)
    replay = WorldReplay(tape, WorldSettings(contacts=True), trails=["cart"])
    found = run_in_page(
        replay.to_html(),
        LOOK
        + """
        const at = (time) => {
          seek(time);
          const guest = view.scene.frames.find(({ label }) => label === "guest::base");
          const [contacts, trail] = view.scene.marks;
          return [view.scene.frames[0].p[0], !guest.isHidden, contacts.points.length / 3, trail.lines.length];
        };
        return [0, 0.2, 0.5, 0.9].map(at);
        """,
    )
    places, guests, contacts, trails = zip(*found, strict=True)
    assert places[0] == pytest.approx(0.0, abs=0.01)
    assert list(places) == sorted(places)
    assert places[-1] > 0.3
    assert guests == (False, False, True, False)
    assert contacts[2] > contacts[1] > 0
    assert list(trails) == sorted(trails)
    assert trails[-1] > trails[1] > 0


def test_a_live_window_moves_with_the_simulation(sim, cart, run_in_page):
    live = LiveWorld(WorldSource(sim.gazebo, WorldSettings(contacts=True), is_live=True))
    page = live.to_html()
    cart.model.set_pose(cart.model.pose._replace(translation=(0.25, 0.0, 0.5)))
    sim.run(0.001)
    live.refresh()
    try:
        x, points = run_in_page(
            page,
            LOOK
            + """
            const isThere = () => view.scene.frames[0].p[0] > 0.2 && !view.scene.marks[0].points.length;
            for (let i = 0; i < 300 && !isThere(); i++) await frame();
            return [view.scene.frames[0].p[0], view.scene.marks[0].points.length];
            """,
        )
    finally:
        live.close()
    assert x == pytest.approx(0.25)
    assert points == 0
