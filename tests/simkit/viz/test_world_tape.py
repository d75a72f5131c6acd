from __future__ import annotations

import math

import pytest

from simkit.errors import UnknownNameError
from simkit.msgs import Time, message_class
from simkit.viz.stage.world_scene import WorldSettings
from simkit.viz.world_recording import WorldTape
from simkit.viz.world_tape import Way, link_ways, odometry_ways, trail_track, world_scene_tape


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
    return world_scene_tape(tape, WorldSettings(**settings), trails=trails)


def test_every_link_that_ever_was_has_a_track_with_few_rows(tape):
    found = play(tape)
    names = [pose.name for pose in found.scene.tf.poses]
    assert [name.partition("::")[0] for name in names] == ["cart"] * 3 + ["guest"] * 3
    assert len(found.tracks) == len(names)
    rows = found.tracks[names.index("cart::base")].rows
    assert (rows[0][0], rows[-1][0]) == pytest.approx((0.0, 1.0))
    assert len(rows) < len(tape.link("cart", "base"))
    assert rows[-1][1] > rows[0][1] + 0.2


def test_a_guest_comes_and_goes(tape):
    found = play(tape)
    names = [pose.name for pose in found.scene.tf.poses]
    number = names.index("guest::base")
    assert found.tracks[number].rows[0][0] == pytest.approx(0.33, abs=0.04)
    assert found.tracks[number].until == pytest.approx(0.62, abs=0.04)
    assert found.tracks[0].until is None


def test_the_stage_holds_the_whole_way(tape):
    stage = play(tape).scene.stage
    xs = [row[1] for row in tape.link("cart", "base")]
    assert stage.cell * stage.grid_x[0] < min(xs)
    assert stage.cell * stage.grid_x[1] > max(xs)
    assert stage.cell * stage.grid_y[1] > 2.0


def test_contacts_are_there_if_asked_for(tape):
    assert play(tape).marks == ()
    (contacts,) = play(tape, contacts=True).marks
    assert contacts.marks.name == "contacts"
    assert [time for time, _ in contacts.moments] == [time for time, _ in tape.contacts]
    assert contacts.moments[0][1].points


def test_a_trail_joins_the_places_of_a_link(tape):
    (trail,) = play(tape, "cart").marks
    assert trail.marks.label == "Trail of cart::base"
    places = [place for _, shown in trail.moments for place in shown.lines[0]]
    rows = tape.link("cart", "base")
    assert places[0] == rows[0][1:4]
    assert places[-1] == rows[-1][1:4]
    assert trail.keep >= len(trail.moments)
    (of_lid,) = play(tape, "cart::lid").marks
    assert of_lid.marks.lines[0][-1] == tape.link("cart", "lid")[-1][1:4]


def test_unknown_names_are_refused(tape):
    with pytest.raises(UnknownNameError, match="no recorded model or link 'cartt'"):
        play(tape, "cartt")
    with pytest.raises(UnknownNameError, match="no model 'x'"):
        play(tape, look_at="x")


class Odometry:
    """A recording of an odometry that goes along its own x, with a robot that looks there."""

    def __init__(self, start_ns, *, child="base", x0=7.0):
        self._messages = []
        for number in range(11):
            message = message_class("nav_msgs/Odometry")()
            message.child_frame_id = child
            message.pose.pose.position.x = x0 + 0.1 * number
            message.pose.pose.orientation.w = 1.0
            self._messages.append((Time.from_nsec(start_ns + number * 50_000_000), message))

    def topics(self):
        return ["/chatter", "/odom"]

    def __getitem__(self, topic):
        if topic == "/odom":
            return self._messages
        return [(Time.from_nsec(0), message_class("std_msgs/String")(data="hello"))]


@pytest.fixture
def tape_trails(sim, cart):
    quarter = (0.0, 0.0, math.sqrt(0.5), math.sqrt(0.5))
    cart.model.set_pose(cart.model.pose._replace(translation=(1.0, 2.0, 0.05), rotation=quarter))
    tape_trails = WorldTape(sim.gazebo, sim.gazebo.node)
    sim.run(0.5)
    return tape_trails


def test_odometry_begins_where_its_link_was_and_as_that_was_turned(tape_trails):
    (way,) = odometry_ways(tape_trails, Odometry(tape_trails.start_ns))
    assert way.label == "Odometry /odom"
    assert [time for time, _ in way.places] == pytest.approx([0.0, 0.1, 0.2, 0.3, 0.4, 0.5])
    assert way.places[0][1] == pytest.approx((1.0, 2.0, 0.05), abs=1e-3)
    assert way.places[-1][1] == pytest.approx((1.0, 3.0, 0.05), abs=1e-3)


def test_odometry_of_an_unknown_link_is_where_it_says(tape_trails):
    (way,) = odometry_ways(tape_trails, Odometry(tape_trails.start_ns, child="nobody"))
    assert way.places[0][1] == pytest.approx((7.0, 0.0, 0.0))


def test_what_was_before_the_beginning_and_what_is_no_number_is_left_out(tape_trails):
    (way,) = odometry_ways(tape_trails, Odometry(tape_trails.start_ns - 50_000_000, child="nobody"))
    assert way.places[0] == (0.0, pytest.approx((7.1, 0.0, 0.0)))
    assert list(odometry_ways(tape_trails, Odometry(tape_trails.start_ns, x0=math.nan))) == []


def test_the_way_of_a_link_has_its_first_and_its_last_place(tape_trails):
    (way,) = link_ways(tape_trails, ["cart::mast"])
    rows = tape_trails.link("cart", "mast")
    assert way.places[0] == (rows[0][0], rows[0][1:4])
    assert way.places[-1] == (rows[-1][0], rows[-1][1:4])
    assert len(way.places) < len(rows)


def test_a_trail_grows_line_by_line():
    way = Way(
        label="w", places=((0.0, (0.0, 0.0, 0.0)), (0.1, (1.0, 0.0, 0.0)), (0.2, (1.0, 1.0, 0.0)))
    )
    track = trail_track(1, way)
    assert track.marks.lines == (((0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (1.0, 1.0, 0.0)),)
    assert [(time, shown.lines) for time, shown in track.moments] == [
        (0.1, (((0.0, 0.0, 0.0), (1.0, 0.0, 0.0)),)),
        (0.2, (((1.0, 0.0, 0.0), (1.0, 1.0, 0.0)),)),
    ]
    assert track.marks.color != trail_track(0, way).marks.color
