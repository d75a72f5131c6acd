"""JointStateController: positions, velocities and efforts of all joints, so many times a second."""

from __future__ import annotations

import pytest

from tests.simkit.plugins.control.conftest import arm

TYPE = "joint_state_controller/JointStateController"
STATE = "sensor_msgs/JointState"


def test_it_says_where_all_joints_are(bench):
    bench.put(arm("EffortJointInterface"))
    heard = bench.stage.listen("/joint_states", STATE)
    assert bench.start("js", TYPE, publish_rate=50)
    bench.stage.run(0.5)
    stamps = [one.header.stamp.to_sec() for one in heard]
    assert stamps == pytest.approx([0.021 + 0.02 * number for number in range(24)])
    last = heard[-1]
    assert list(last.name) == ["hip", "shoulder"]
    assert last.position[0] > 0.1, "it falls"
    assert last.velocity[0] > 0.1
    assert list(last.effort) == [0.0, 0.0]


def test_its_stamp_is_the_time_at_which_joints_stand_so(bench):
    bench.put(arm("EffortJointInterface"))
    heard = bench.stage.listen("/joint_states", STATE)
    assert bench.start("js", TYPE, publish_rate=100)
    bench.stage.run(0.011)
    assert heard[-1].header.stamp.to_nsec() == 11_000_000
    assert list(heard[-1].position) == bench.positions()


def test_it_claims_nothing(bench):
    bench.put(arm())
    assert bench.start("js", TYPE, publish_rate=50)
    kind = "position_controllers/JointGroupPositionController"
    assert bench.start("c", kind, joints=["hip", "shoulder"])
    listed = bench.call(
        "/controller_manager/list_controllers", "controller_manager_msgs/ListControllers"
    )
    (claim,) = listed.controller[0].claimed_resources
    assert claim.hardware_interface == "hardware_interface::JointStateInterface"
    assert list(claim.resources) == []


def test_two_who_say_where_joints_are_are_named(bench):
    bench.put(arm())
    assert bench.start("js", TYPE, publish_rate=50)
    assert bench.said() == []
    assert bench.start("js2", TYPE, publish_rate=50)
    assert "publishes /joint_states already, and js2 does now" in bench.said()[-1]


def test_joints_that_nobody_moves_can_be_added(bench):
    bench.put(arm())
    heard = bench.stage.listen("/joint_states", STATE)
    assert bench.start("js", TYPE, publish_rate=50, extra_joints=[{"name": "lid", "position": 0.5}])
    bench.stage.run(0.1)
    assert list(heard[-1].name) == ["hip", "shoulder", "lid"]
    assert list(heard[-1].position) == [0.0, 0.0, 0.5]


@pytest.mark.parametrize(
    ("parameters", "text"),
    [
        ({}, "Parameter 'publish_rate' not set"),
        ({"publish_rate": "fast"}, "The parameter /js/publish_rate must be a number, not 'fast'."),
        (
            {"publish_rate": 50, "extra_joints": [{"name": "lid", "position": "open"}]},
            "Extra joint {'name': 'lid', 'position': 'open'} has a value that is no number.",
        ),
        (
            {"publish_rate": 50, "extra_joints": [{}]},
            "Extra joint {} has no name (namespace: /js).",
        ),
    ],
)
def test_it_is_not_loaded_without_good_parameters(bench, parameters, text):
    bench.put(arm())
    assert not bench.start("js", TYPE, **parameters)
    assert text in bench.said()
