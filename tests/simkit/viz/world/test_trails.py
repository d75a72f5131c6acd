from __future__ import annotations

import math

import pytest

from simkit.msgs import Time, message_class
from simkit.viz.world import WorldTape
from simkit.viz.world.trails import Way, link_ways, odometry_ways, trail_track


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
def tape(sim, cart):
    quarter = (0.0, 0.0, math.sqrt(0.5), math.sqrt(0.5))
    cart.model.set_pose(cart.model.pose._replace(translation=(1.0, 2.0, 0.05), rotation=quarter))
    tape = WorldTape(sim.gazebo, sim.gazebo.node)
    sim.run(0.5)
    return tape


def test_odometry_begins_where_its_link_was_and_as_that_was_turned(tape):
    (way,) = odometry_ways(tape, Odometry(tape.start_ns))
    assert way.label == "Odometry /odom"
    assert [time for time, _ in way.places] == pytest.approx([0.0, 0.1, 0.2, 0.3, 0.4, 0.5])
    assert way.places[0][1] == pytest.approx((1.0, 2.0, 0.05), abs=1e-3)
    assert way.places[-1][1] == pytest.approx((1.0, 3.0, 0.05), abs=1e-3)


def test_odometry_of_an_unknown_link_is_where_it_says(tape):
    (way,) = odometry_ways(tape, Odometry(tape.start_ns, child="nobody"))
    assert way.places[0][1] == pytest.approx((7.0, 0.0, 0.0))


def test_what_was_before_the_beginning_and_what_is_no_number_is_left_out(tape):
    (way,) = odometry_ways(tape, Odometry(tape.start_ns - 50_000_000, child="nobody"))
    assert way.places[0] == (0.0, pytest.approx((7.1, 0.0, 0.0)))
    assert list(odometry_ways(tape, Odometry(tape.start_ns, x0=math.nan))) == []


def test_the_way_of_a_link_has_its_first_and_its_last_place(tape):
    (way,) = link_ways(tape, ["cart::mast"])
    rows = tape.link("cart", "mast")
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
