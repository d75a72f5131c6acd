"""The bumper: what touches, where, and how hard."""

from __future__ import annotations

import pytest

from simkit.graph import LogLevel
from tests.simkit.plugins.samples import END_OF_SENSOR, Sample, in_sensor, link

SAMPLE = Sample(
    robot=link("bob", '<box size="0.2 0.2 0.2"/>'),
    tags={"bumperTopicName": "bumps"},
    before=in_sensor("contact", "<contact><collision>bob_collision</collision></contact>"),
    after=END_OF_SENSOR,
)

STATES = "gazebo_msgs/ContactsState"
G = 9.8


@pytest.fixture
def bumper(link):
    """Writes a box of 2 kg with a contact sensor."""

    def make(
        collision: str = "<collision>base_collision</collision>", *, rate: float = 0, more: str = ""
    ) -> str:
        return f"""{link(mass=2.0)}<gazebo reference="base"><sensor name="bump" type="contact">
          <update_rate>{rate}</update_rate><contact>{collision}</contact>
          <plugin name="bump" filename="libgazebo_ros_bumper.so">{more}</plugin>
        </sensor></gazebo>"""

    return make


def test_the_forces_bear_the_weight(stage, bumper):
    stage.spawn(bumper(), pose=stage.at(z=0.1))
    heard = stage.listen("/bumper_states", STATES)
    stage.run(0.5)
    (state,) = heard[-1].states
    force = state.total_wrench.force
    assert [force.x, force.y, force.z] == pytest.approx([0, 0, 2 * G], rel=1e-3, abs=1e-3)
    assert sum(one.force.z for one in state.wrenches) == pytest.approx(force.z)
    assert state.collision1_name == "r::base::base_collision"
    assert state.collision2_name == "ground_plane::link::collision"


def test_points_normals_and_depths_belong_to_the_points(stage, bumper):
    stage.spawn(bumper(), pose=stage.at(1, 2, 0.1))
    heard = stage.listen("/bumper_states", STATES)
    stage.run(0.5)
    (state,) = heard[-1].states
    corners = sorted((round(p.x, 3), round(p.y, 3)) for p in state.contact_positions)
    assert corners == [(0.9, 1.9), (0.9, 2.1), (1.1, 1.9), (1.1, 2.1)]
    for normal in state.contact_normals:
        assert [normal.x, normal.y, normal.z] == pytest.approx([0, 0, 1], abs=1e-9)
    assert len(state.depths) == len(state.wrenches) == 4


def test_in_the_air_it_says_that_nothing_touches(stage, bumper):
    stage.spawn(bumper(), pose=stage.at(z=3))
    heard = stage.listen("/bumper_states", STATES)
    stage.run(0.05)
    assert len(heard) >= 40
    assert all(one.states == [] for one in heard)
    assert heard[0].header.frame_id == "world"


def test_it_tells_of_all_steps_since_it_was_told_last(stage, bumper):
    stage.spawn(bumper(rate=50), pose=stage.at(z=0.1))
    heard = stage.listen("/bumper_states", STATES)
    stage.run(0.5)
    assert heard[-1].header.stamp.to_nsec() % 20_000_000 == 0
    assert len(heard[-1].states) == 20
    assert len({one.info for one in heard[-1].states}) == 20


def test_only_the_shape_that_is_named_is_felt(stage, bumper, link):
    stage.spawn(bumper(), pose=stage.at(z=0.1))
    stage.spawn(link("other"), name="other", pose=stage.at(3, 0, 0.1))
    heard = stage.listen("/bumper_states", STATES)
    stage.run(0.3)
    assert {one.collision1_name for one in heard[-1].states} == {"r::base::base_collision"}


def test_a_thing_on_top_is_a_state_of_its_own(stage, bumper, link):
    stage.spawn(bumper(), pose=stage.at(z=0.1))
    stage.spawn(link("other", mass=0.5), name="other", pose=stage.at(z=0.3))
    heard = stage.listen("/bumper_states", STATES)
    stage.run(0.5)
    pairs = {
        frozenset((one.collision1_name, one.collision2_name)): abs(one.total_wrench.force.z)
        for one in heard[-1].states
    }
    mine = "r::base::base_collision"
    ground, top = "ground_plane::link::collision", "other::other::other_collision"
    assert set(pairs) == {frozenset((mine, ground)), frozenset((mine, top))}
    assert pairs[frozenset((mine, ground))] == pytest.approx(2.5 * G, rel=0.01)
    assert pairs[frozenset((mine, top))] == pytest.approx(0.5 * G, rel=0.01)


def test_topic_and_frame_are_those_of_the_tag(stage, bumper):
    more = "<bumperTopicName>bump</bumperTopicName><frameName>/base</frameName>"
    stage.spawn(bumper(more=more), pose=stage.at(z=0.1), namespace="/car")
    heard = stage.listen("/car/bump", STATES)
    stage.run(0.05)
    assert heard[0].header.frame_id == "base"


def test_a_shape_that_is_not_there_is_told_with_those_that_are(stage, bumper):
    stage.spawn(bumper("<collision>base_colision</collision>"), pose=stage.at(z=0.1))
    (warning,) = stage.said(LogLevel.WARN)
    assert warning.startswith("r.urdf:2:")
    assert "did you mean base_collision? shapes here: base_collision" in warning


def test_a_sensor_without_a_shape_is_told(stage, bumper):
    stage.spawn(bumper(""), pose=stage.at(z=0.1))
    (warning,) = stage.said(LogLevel.WARN)
    assert "feels nothing: it needs <contact><collision>" in warning
