"""static_transform_publisher of tf and of tf2_ros."""

from __future__ import annotations

import math

import pytest

from simkit.msgs import Time
from simkit.nodes.tf_tools import static_publisher

PACKAGES = {"tf": ["100"], "tf2_ros": []}


def run(sim, package, words, seconds=1.0):
    node = sim.rosrun(package, "static_transform_publisher", *words.split(), *PACKAGES[package])
    sim.run(seconds)
    return node


def place(sim, parent="world", child="a"):
    found = sim.tf.lookup_transform(parent, child).transform
    t, q = found.translation, found.rotation
    return [t.x, t.y, t.z], [q.x, q.y, q.z, q.w]


@pytest.mark.parametrize("package", PACKAGES)
@pytest.mark.parametrize(
    ("words", "rotation"),
    [
        ("1 2 3 1.5707963 0 0 world a", [0, 0, math.sqrt(0.5), math.sqrt(0.5)]),
        ("1 2 3 0 1.5707963 0 world a", [0, math.sqrt(0.5), 0, math.sqrt(0.5)]),
        ("1 2 3 0 0 1.5707963 world a", [math.sqrt(0.5), 0, 0, math.sqrt(0.5)]),
        # roll about x first, then pitch, then yaw: of tf.transformations (0.3, 0.2, 0.1).
        ("1 2 3 0.1 0.2 0.3 world a", [0.14357218, 0.10602051, 0.03427080, 0.98334744]),
        ("1 2 3 0 0 1 0 world a", [0, 0, 1, 0]),
    ],
)
def test_six_or_seven_numbers(sim, package, words, rotation):
    run(sim, package, words)
    translation, found = place(sim)
    assert translation == [1, 2, 3]
    assert found == pytest.approx(rotation, abs=1e-6)


def test_that_of_tf_repeats_and_dates_ahead(sim):
    recording = sim.record({"/tf": "tf2_msgs/TFMessage"})
    run(sim, "tf", "1 0 0 0 0 0 world a")
    times = [(time, message.transforms[0].header.stamp) for time, message in recording["/tf"]]
    assert len(times) == 11
    assert all((stamp - time).to_sec() == pytest.approx(0.1) for time, stamp in times)
    assert sim.tf.can_transform("world", "a", sim.now)


def test_that_of_tf2_latches_and_holds_for_ever(sim, said):
    node = run(sim, "tf2_ros", "1 0 0 0 0 0 world a", seconds=100)
    assert sim.tf.can_transform("world", "a", Time(3))
    assert said("INFO") == ["Spinning until killed publishing world to a"]
    late = sim.rosrun("tf", "tf_echo", "world", "a")
    sim.run(0.1)
    assert "- Translation: [1.000, 0.000, 0.000]" in late.output
    assert node.alive


def test_that_of_tf2_reads_a_parameter(sim, said):
    transform = {
        "header": {"frame_id": "world"},
        "child_frame_id": "a",
        "transform": {"translation": {"x": 4}, "rotation": {"w": 1.0}},
    }
    sim.params.set("/pose", transform)
    run(sim, "tf2_ros", "/pose")
    assert place(sim)[0] == [4, 0, 0]
    for name, text in (("/nope", "Could not read"), ("/wrong", "Could not validate")):
        sim.params.set("/wrong", {"parent": "world"})
        node = run(sim, "tf2_ros", name)
        assert node.program.exit_code == 1
        assert said("FATAL")[-1].startswith(text)


@pytest.mark.parametrize("package", PACKAGES)
def test_the_order_of_angles_is_told_where_it_matters(sim, said, package):
    run(sim, package, "0 0 0 1.57 0 0 world a")
    run(sim, package, "0 0 0 0 1.57 0 world b")
    told = [text for text in said("INFO") if "read as" in text]
    assert told == [
        "a: read as yaw 1.57, pitch 0, roll 0 [rad]; the rpy of a URDF counts the other way "
        "round and would mean yaw 0, pitch 0, roll 1.57"
    ]


@pytest.mark.parametrize(
    ("package", "usage"),
    [("tf", static_publisher.TF_USAGE), ("tf2_ros", static_publisher.TF2_USAGE)],
)
@pytest.mark.parametrize("words", ["", "1 0 0", "1 0 0 0 0 0 0 0 0 world a b c"])
def test_a_wrong_number_of_words(sim, said, package, usage, words):
    node = run(sim, package, words)
    assert not node.alive
    assert node.program.exit_code == 255
    assert node.output == usage
    assert "not having the right number of arguments" in said("ERROR")[0]


def test_a_period_is_not_for_tf2(sim, said):
    node = run(sim, "tf2_ros", "1 0 0 0 0 0 world a 100")
    assert node.program.exit_code == 255
    assert said("ERROR")[0].endswith(
        "; the last number looks like a period, which tf takes and tf2_ros does not"
    )


@pytest.mark.parametrize("package", PACKAGES)
@pytest.mark.parametrize(
    ("words", "text"),
    [
        (
            "1 0 0 0 0 0 world world",
            "target_frame and source frame are the same (world, world) this cannot work",
        ),
        ("1 O 0 0 0 0 world a", "y must be a number, not 'O'; the order is x y z yaw pitch roll"),
        ("1 0 0 0 0 0 x world a", "qw must be a number, not 'x'; the order is x y z qx qy qz qw"),
    ],
)
def test_words_that_make_no_transform(sim, said, package, words, text):
    node = run(sim, package, words)
    assert node.program.exit_code == 1
    assert text in said("FATAL")[0]


def test_a_period_is_positive(rosrun, said):
    node = rosrun("tf static_transform_publisher 1 0 0 0 0 0 world a 0")
    assert node.program.exit_code == 1
    assert "the period must be a positive number of milliseconds, not '0'" in said("FATAL")[0]


def test_a_rotation_that_is_none_is_warned_of(sim, said):
    run(sim, "tf", "1 0 0 0 0 1.57 0 world a")
    assert "norm 1.57 instead of 1" in said("WARN")[0]
