from __future__ import annotations

from itertools import pairwise

import pytest

from simkit.errors import SimkitError, UnknownNameError
from simkit.viz.world_recording import WorldTape


@pytest.fixture
def tape(sim, cart):
    return WorldTape(sim.gazebo, sim.gazebo.node, rate=50.0)


def test_it_looks_at_once_and_then_every_period(sim, cart, tape):
    sim.run(0.1)
    rows = tape.link("cart", "base")
    assert [row[0] for row in rows] == pytest.approx([0.0, 0.02, 0.04, 0.06, 0.08, 0.1])
    assert rows[-1][1:4] == cart.model.link_pose("base").translation
    assert tape.duration == pytest.approx(0.1)
    assert repr(tape) == "WorldTape(0.10 s of cart)"


def test_periods_are_whole_milliseconds(sim, cart):
    tape = WorldTape(sim.gazebo, sim.gazebo.node)
    sim.run(0.1)
    assert [row[0] for row in tape.link("cart", "lid")] == pytest.approx([0.0, 0.033, 0.066, 0.099])


def test_the_end_is_kept_when_it_is_stopped_and_nothing_afterwards(sim, cart, tape):
    sim.run(0.05)
    tape.stop()
    assert tape.duration == pytest.approx(0.05)
    sim.run(0.1)
    tape.look()
    assert tape.duration == pytest.approx(0.05)


def test_joints_are_kept_with_their_speed(sim, cart, tape):
    cart.model.joint("hinge").command_velocity(1.0, effort=5.0)
    sim.run(0.5)
    rows = tape.joint("cart", "hinge")
    assert rows[0][1] == pytest.approx(0.0, abs=0.2)
    assert rows[-1][1] == cart.model.joint("hinge").position
    assert rows[10][2] == pytest.approx(1.0, abs=1e-3)


def test_contacts_are_kept(sim, cart, tape):
    sim.run(0.1)
    times = [time for time, found in tape.contacts if found]
    assert times == pytest.approx([0.0, 0.02, 0.04, 0.06, 0.08, 0.1])


def test_scans_are_kept_ten_times_a_second(sim, m2wr, cart_text):
    sim.spawn(cart_text, name="cart", xyz=(1.0, 0.0, 0.12))
    tape = WorldTape(sim.gazebo, sim.gazebo.node, rate=50.0)
    sim.run(0.5)
    assert [time for time, _ in tape.scans] == pytest.approx([0.0, 0.1, 0.2, 0.3, 0.4, 0.5])


def test_models_that_come_and_go_are_told_apart(sim, cart, cart_text, tape):
    sim.run(0.1)
    sim.gazebo.delete("cart")
    sim.run(0.1)
    sim.spawn(cart_text, name="cart", xyz=(3.0, 0.0, 0.05))
    sim.run(0.1)
    tape.look()
    _, old, new = tape.tracks
    assert (old.actor.name, new.actor.name) == ("cart", "cart (2)")
    assert old.until == pytest.approx(0.12)
    assert new.until is None
    assert tape.link("cart", "base")[0][1] == pytest.approx(3.0)
    assert set(new.links) == {"cart (2)::base", "cart (2)::mast", "cart (2)::lid"}


def test_a_quaternion_never_jumps_to_its_negative(sim, cart, tape):
    cart.model.set_pose(cart.model.pose._replace(translation=(0.0, 0.0, 50.0)))
    cart.model.set_twist((0.0, 0.0, 0.0), (0.0, 0.0, 12.0))
    sim.run(1.0)
    turns = [row[4:] for row in tape.link("cart", "base")]
    for before, after in pairwise(turns):
        assert sum(a * b for a, b in zip(before, after, strict=True)) > 0.9


def test_the_world_does_not_notice(sim, cart):
    def end(*, recorded):
        sim.gazebo.reset_world()
        cart.model.set_twist((0.3, 0.0, 1.0), (0.0, 2.0, 1.0))
        tape = WorldTape(sim.gazebo, sim.gazebo.node, rate=70.0) if recorded else None
        sim.run(0.7)
        if tape:
            tape.stop()
        return cart.model.pose, cart.model.joint("hinge").position

    assert end(recorded=True) == end(recorded=False)


def test_unknown_names_are_told_with_near_ones(tape):
    with pytest.raises(UnknownNameError, match="no recorded model 'card'"):
        tape.link("card", "base")
    with pytest.raises(UnknownNameError, match="no link in 'cart' 'bose'; did you mean 'base'"):
        tape.link("cart", "bose")
    with pytest.raises(UnknownNameError, match="'hing'"):
        tape.joint("cart", "hing")


@pytest.mark.parametrize("rate", [0.0, -1.0, 2000.0, float("nan")])
def test_a_rate_must_make_sense(sim, cart, rate):
    with pytest.raises(SimkitError, match="times a second"):
        WorldTape(sim.gazebo, sim.gazebo.node, rate=rate)
