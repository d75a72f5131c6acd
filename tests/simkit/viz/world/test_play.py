from __future__ import annotations

import pytest

from simkit.errors import UnknownNameError
from simkit.viz.world.play import world_play
from simkit.viz.world.settings import WorldSettings
from simkit.viz.world.tape import WorldTape


@pytest.fixture
def tape(sim, cart, cart_text):
    """A cart that slides for a second; another one is there for the middle of it."""
    tape = WorldTape(sim.gazebo, sim.gazebo.node)
    cart.model.set_twist((3.0, 0.0, 0.0), (0.0, 0.0, 0.0))
    sim.run(0.3)
    sim.spawn(cart_text, name="guest", xyz=(0.0, 2.0, 0.05))
    sim.run(0.3)
    sim.gazebo.delete("guest")
    sim.run(0.4)
    tape.stop()
    return tape


def play(tape, *trails, **settings):
    return world_play(tape, WorldSettings(**settings), trails=trails)


def test_every_link_that_ever_was_has_a_track_with_few_rows(tape):
    found = play(tape)
    names = [pose.name for pose in found.scene.tf.poses]
    assert [name.partition("::")[0] for name in names] == ["cart"] * 3 + ["guest"] * 3
    assert len(found.tracks) == len(found.until) == len(names)
    rows = found.tracks[names.index("cart::base")]
    assert (rows[0][0], rows[-1][0]) == pytest.approx((0.0, 1.0))
    assert len(rows) < len(tape.link("cart", "base"))
    assert rows[-1][1] > rows[0][1] + 0.2


def test_a_guest_comes_and_goes(tape):
    found = play(tape)
    names = [pose.name for pose in found.scene.tf.poses]
    number = names.index("guest::base")
    assert found.tracks[number][0][0] == pytest.approx(0.33, abs=0.04)
    assert found.until[number] == pytest.approx(0.62, abs=0.04)
    assert found.until[0] is None


def test_the_stage_holds_the_whole_way(tape):
    stage = play(tape).scene.stage
    xs = [row[1] for row in tape.link("cart", "base")]
    assert stage.cell * stage.grid_x[0] < min(xs)
    assert stage.cell * stage.grid_x[1] > max(xs)
    assert stage.cell * stage.grid_y[1] > 2.0


def test_contacts_are_there_if_asked_for(tape):
    assert play(tape).displays == ()
    (contacts,) = play(tape, contacts=True).displays
    assert contacts.marks.name == "contacts"
    assert [time for time, _ in contacts.moments] == [time for time, _ in tape.contacts]
    assert contacts.moments[0][1].points


def test_a_trail_joins_the_places_of_a_link(tape):
    (trail,) = play(tape, "cart").displays
    assert trail.marks.label == "Trail of cart::base"
    places = [place for _, shown in trail.moments for place in shown.lines[0]]
    rows = tape.link("cart", "base")
    assert places[0] == rows[0][1:4]
    assert places[-1] == rows[-1][1:4]
    assert trail.keep >= len(trail.moments)
    (of_lid,) = play(tape, "cart::lid").displays
    assert of_lid.marks.lines[0][-1] == tape.link("cart", "lid")[-1][1:4]


def test_unknown_names_are_refused(tape):
    with pytest.raises(UnknownNameError, match="no recorded model or link 'cartt'"):
        play(tape, "cartt")
    with pytest.raises(UnknownNameError, match="no model 'x'"):
        play(tape, look_at="x")
