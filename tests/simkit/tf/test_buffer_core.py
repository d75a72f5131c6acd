"""Lookups: the scenarios and numbers of tf's own tests."""

from __future__ import annotations

import itertools
import math

import pytest

from simkit.geometry import Transform
from simkit.tf.errors import (
    ConnectivityException,
    ExtrapolationException,
    InvalidArgumentException,
    LookupException,
)

NS = 1e-9
STAMPS = [1.0, 10.0, 0.0]
STAMP_IDS = ["at 1 s", "at 10 s", "latest"]
IDENTITY = (0.0, 0.0, 0.0, 1.0)


# -- unknown frames


def test_nothing_is_known_to_an_empty_buffer(tree):
    with pytest.raises(LookupException) as caught:
        tree.lookup("a", "b", 1.0)
    assert str(caught.value) == (
        '"a" passed to lookupTransform argument target_frame does not exist. '
    )
    assert tree.core.can_transform("a", "b", time=10**9) == (
        False,
        "canTransform: target_frame a does not exist. canTransform: source_frame b does not exist.",
    )


def test_one_unknown_frame_is_enough(tree):
    tree.put("foo", "child", 1.0)
    with pytest.raises(LookupException) as caught:
        tree.lookup("foo", "bar", 1.0)
    assert str(caught.value) == (
        '"bar" passed to lookupTransform argument source_frame does not exist. '
    )
    assert not tree.can("foo", "bar", 1.0)


def test_unknown_fixed_frame(tree):
    tree.put("w", "a", 1.0)
    with pytest.raises(LookupException) as caught:
        tree.full("w", 1.0, "a", 1.0, "nope")
    assert str(caught.value) == (
        '"nope" passed to lookupTransform argument fixed_frame does not exist. '
    )
    answer = tree.core.can_transform_full("w", "a", target_time=0, source_time=0, fixed="nope")
    assert answer == (False, "fixed_frame: nopedoes not exist.")
    answer = tree.core.can_transform_full("w", "b", target_time=0, source_time=0, fixed="nope")
    assert answer == (
        False,
        "canTransform: source_frame b does not exist. fixed_frame: nopedoes not exist.",
    )


def test_no_parent_is_not_a_frame(tree):
    tree.put("w", "a", 1.0)
    with pytest.raises(LookupException):
        tree.lookup("NO_PARENT", "a")
    tree.put("NO_PARENT", "b", 1.0)
    assert tree.lookup("b", "b").rotation == IDENTITY
    with pytest.raises(ConnectivityException):
        tree.lookup("w", "b")
    assert tree.core.parent_of("b") is None


# -- names


@pytest.mark.parametrize("name", ["", "/b"])
def test_invalid_names(tree, name):
    tree.chain_of("a", "b", "c", step=(1, 0, 0), t=1.0)
    assert tree.lookup("b", "a").translation == (-1, 0, 0)
    for pair in ((name, "a"), ("a", name)):
        with pytest.raises(InvalidArgumentException):
            tree.lookup(*pair)
        assert tree.core.can_transform(*pair) == (False, "")
    assert len(tree.warnings) == 2


def test_texts_for_invalid_names(tree):
    tree.put("w", "a", 1.0)
    with pytest.raises(InvalidArgumentException) as caught:
        tree.lookup("", "a")
    assert str(caught.value) == (
        "Invalid argument passed to lookupTransform argument target_frame in tf2 "
        "frame_ids cannot be empty"
    )
    with pytest.raises(InvalidArgumentException) as caught:
        tree.lookup("a", "/w")
    assert str(caught.value) == (
        'Invalid argument "/w" passed to lookupTransform argument source_frame in tf2 '
        "frame_ids cannot start with a '/' like: "
    )
    tree.can("/w", "a")
    assert tree.warnings == [
        'Invalid argument "/w" passed to canTransform argument target_frame in tf2 '
        "frame_ids cannot start with a '/' like: "
    ]


@pytest.mark.parametrize("name", ["", "/a", "unknown"])
def test_a_frame_in_itself_is_never_refused(tree, name):
    found = tree.lookup(name, name, 7.0)
    assert found == (Transform(), 7 * 10**9)
    assert tree.lookup(name, name).stamp == 0
    assert tree.can(name, name, 7.0)


def test_a_frame_in_itself_has_its_own_newest_stamp(tree):
    tree.put("w", "a", 3.0)
    tree.put("w", "a", 4.0)
    assert tree.lookup("a", "a").stamp == 4 * 10**9
    assert tree.lookup("w", "w").stamp == 0


# -- trees of tf2's buffer_core_test


def check(tree, target, source, xyz, t):
    found = tree.lookup(target, source, t)
    assert found.translation == pytest.approx(xyz, abs=1e-6)
    assert found.rotation == pytest.approx(IDENTITY, abs=1e-6)
    if t:
        assert found.stamp == round(t * 10**9)


@pytest.mark.parametrize("t", STAMPS, ids=STAMP_IDS)
def test_i(tree, t):
    tree.chain_of("a", "b", "c", step=(1, 0, 0), t=t)
    expected = {
        ("a", "b"): 1, ("b", "c"): 1, ("b", "a"): -1, ("c", "b"): -1,
        ("a", "c"): 2, ("c", "a"): -2, ("a", "a"): 0, ("b", "b"): 0, ("c", "c"): 0,
    }  # fmt: skip
    for (target, source), x in expected.items():
        check(tree, target, source, (x, 0, 0), t)


@pytest.mark.parametrize("t", STAMPS, ids=STAMP_IDS)
def test_one_link(tree, t):
    tree.put("1", "2", t, (1, 0, 0))
    check(tree, "1", "2", (1, 0, 0), t)
    check(tree, "2", "1", (-1, 0, 0), t)


V = {
    ("a", "g"): (0, 2), ("g", "a"): (0, -2), ("b", "f"): (-1, 1), ("f", "b"): (1, -1),
    ("c", "f"): (-2, 1), ("f", "c"): (2, -1), ("b", "g"): (-1, 2), ("g", "b"): (1, -2),
    ("c", "g"): (-2, 2), ("g", "c"): (2, -2),
}  # fmt: skip

Y = {
    ("b", "e"): (0, 2), ("a", "d"): (1, 1), ("d", "a"): (-1, -1), ("c", "d"): (-1, 1),
    ("d", "c"): (1, -1), ("a", "e"): (1, 2), ("e", "a"): (-1, -2), ("c", "e"): (-1, 2),
    ("e", "c"): (1, -2), ("e", "b"): (0, -2),
}  # fmt: skip


@pytest.mark.parametrize("t", STAMPS, ids=STAMP_IDS)
def test_v(tree, t):
    tree.chain_of("a", "b", "c", step=(1, 0, 0), t=t)
    tree.chain_of("a", "f", "g", step=(0, 1, 0), t=t)
    for (target, source), (x, y) in V.items():
        check(tree, target, source, (x, y, 0), t)


@pytest.mark.parametrize("t", STAMPS, ids=STAMP_IDS)
def test_y(tree, t):
    tree.chain_of("a", "b", "c", step=(1, 0, 0), t=t)
    tree.chain_of("b", "d", "e", step=(0, 1, 0), t=t)
    for (target, source), (x, y) in Y.items():
        check(tree, target, source, (x, y, 0), t)


@pytest.mark.parametrize("t", STAMPS, ids=STAMP_IDS)
def test_two_trees_in_one_buffer(tree, t):
    tree.put("1", "2", t, (1, 0, 0))
    tree.chain_of("a", "b", "c", step=(1, 0, 0), t=t)
    tree.chain_of("a", "f", "g", step=(0, 1, 0), t=t)
    check(tree, "1", "2", (1, 0, 0), t)
    for (target, source), (x, y) in V.items():
        check(tree, target, source, (x, y, 0), t)
    for ours in "12":
        for theirs in "abcfg":
            assert not tree.can(ours, theirs, t)
            assert not tree.can(theirs, ours, t)


COMPOUND = {
    ("root", "c"): ((-.745018, 1.576899, .303216), (.721690, .179192, .370253, .556746)),
    ("root", "d"): ((.840334, 1.221849, -.624468), (.863062, .466404, .082370, .175518)),
    ("a", "b"): ((-2.449006, -.511845, -1.655411), (.105332, .344270, -.248214, .899318)),
    ("b", "a"): ((.263710, 1.739091, 2.430231), (-.105332, -.344270, .248214, .899318)),
    ("a", "c"): ((-1.127597, 1.017154, -1.247930), (.551561, .017344, .122706, .824878)),
    ("c", "a"): ((1.000807, .566513, 1.594006), (-.551561, -.017344, -.122706, .824878)),
    ("a", "d"): ((-.213694, -.592036, -1.522313), (.882932, .161873, -.089907, .431445)),
    ("d", "a"): ((-.131982, .852561, -1.403328), (-.882932, -.161873, .089907, .431445)),
    ("c", "b"): ((-1.663095, -.682954, 1.008806), None),
    ("b", "d"): ((1.370619, 1.094005, 1.394749), (.739365, .206728, .313152, .559052)),
    ("d", "b"): ((-2.025609, -.956033, .060627), None),
}  # fmt: skip


@pytest.mark.parametrize("pair", COMPOUND, ids="<-".join)
def test_compound(tree, pair):
    tree.put("root", "a", 0, (1, 1, 1), (.272660403, .022494047, .323415536, .905843648))  # fmt: skip
    tree.put("root", "b", 0, (-1, 0, -1), (.223697334, .433827955, .157509302, .858454208))  # fmt: skip
    tree.put("b", "c", 0, (0, 2, .5), (.362593555, -.118552507, .503157016, .775438092))  # fmt: skip
    tree.put("c", "d", 0, (.5, -1, 1.5), (.511764805, -.031887983, -.201072606, .834655467))  # fmt: skip
    xyz, q = COMPOUND[pair]
    found = tree.lookup(*pair)
    assert found.translation == pytest.approx(xyz, abs=2e-5)
    if q is not None:
        same_sign = math.copysign(1.0, sum(a * b for a, b in zip(q, found.rotation, strict=True)))
        assert [same_sign * c for c in found.rotation] == pytest.approx(q, abs=2e-5)


@pytest.fixture
def helix(tree, yaw):
    """A screw: b rises above a, c circles above b, d goes up and down beside a."""
    for k in range(101):
        t = 10.0 + 0.05 * k
        dt = t - 10.0
        tree.put("a", "b", t, (0, 0, dt))
        tree.put("b", "c", t, (math.cos(dt / 4), math.sin(dt / 4), 0), yaw(dt / 4))
        tree.put("a", "d", t + 0.025, (0, 0, math.cos((dt + 0.025) / 4)))
    return tree


def test_helix_between_stamps(helix, yaw):
    for k in range(99):
        t = 10.025 + 0.05 * k
        dt, t2 = t - 10.0, t + 0.025
        dt2 = t2 - 10.0
        found = helix.lookup("a", "b", t)
        assert found.translation == pytest.approx((0, 0, dt), abs=2e-5)
        found = helix.lookup("a", "c", t)
        assert found.translation == pytest.approx(
            (math.cos(dt / 4), math.sin(dt / 4), dt), abs=2e-5
        )
        assert found.rotation == pytest.approx(yaw(dt / 4), abs=2e-5)
        found = helix.lookup("a", "d", t)
        assert found.translation == pytest.approx((0, 0, math.cos(dt / 4)), abs=2e-5)
        found = helix.lookup("c", "d", t2)
        assert found.translation == pytest.approx((-1, 0, math.cos(dt2 / 4) - dt2), abs=2e-5)
        assert found.rotation == pytest.approx(yaw(-dt2 / 4), abs=2e-5)


def test_helix_with_a_fixed_frame(helix, yaw):
    for k in range(98):
        t = 10.025 + 0.05 * k
        dt, dt2 = t - 10.0, t + 0.05 - 10.0
        found = helix.full("c", t, "d", t + 0.05, "a")
        assert found.translation == pytest.approx((-1, 0, math.cos(dt2 / 4) - dt), abs=2e-5)
        assert found.rotation == pytest.approx(yaw(-dt / 4), abs=2e-5)
        assert found.stamp == round(t * 10**9)


def test_helix_as_observed_in_tf2(helix):
    found = helix.full("c", 12.525, "d", 12.575, "a")
    assert found.translation == pytest.approx((-0.999980469, 0, -1.72514936), abs=1e-8)
    assert found.rotation == pytest.approx((0, 0, -0.310410658, 0.950602558), abs=1e-8)


RING = [
    (math.sqrt(0.5) - 1, math.sqrt(0.5)), (-1, 1), (-1 - math.sqrt(0.5), math.sqrt(0.5)), (-2, 0),
    (-1 - math.sqrt(0.5), -math.sqrt(0.5)), (-1, -1), (math.sqrt(0.5) - 1, -math.sqrt(0.5)), (0, 0),
]  # fmt: skip


@pytest.mark.parametrize("t", STAMPS, ids=STAMP_IDS)
def test_ring_of_45_degrees(tree, yaw, t):
    frames = "abcdefghi"
    for parent, child in itertools.pairwise(frames):
        step = (math.sqrt(0.5) - 1, math.sqrt(0.5), 0)
        tree.put(parent, child, t, step, yaw(math.pi / 4))
    for first in range(9):
        for k in range(1, 9 - first):
            a, b = frames[first], frames[first + k]
            x, y = RING[k - 1]
            sine, cosine = math.sin(k * math.pi / 8), abs(math.cos(k * math.pi / 8))
            there, back = tree.lookup(a, b, t), tree.lookup(b, a, t)
            assert there.translation == pytest.approx((x, y, 0), abs=1e-6)
            assert back.translation == pytest.approx((x, -y, 0), abs=1e-6)
            for q, sign in ((there.rotation, 1), (back.rotation, -1)):
                assert q[2] == pytest.approx(sign * sine, abs=1e-6)
                assert abs(q[3]) == pytest.approx(cosine, abs=1e-6)


# -- times


def test_exceptions(tree):
    with pytest.raises(LookupException):
        tree.lookup("a", "parent", 0.01)
    tree.put("parent", "a", 100_000 * NS)
    for pair in (("a", "parent"), ("parent", "a")):
        with pytest.raises(ExtrapolationException):
            tree.lookup(*pair, 200_000 * NS)
    tree.put("parent", "a", 300_000 * NS)
    for pair in (("a", "parent"), ("parent", "a")):
        tree.lookup(*pair, 200_000 * NS)
        for outside in (1_000, 350_000):
            with pytest.raises(ExtrapolationException):
                tree.lookup(*pair, outside * NS)


def test_two_children_need_no_data_of_their_parents_ancestors(tree):
    for stamp in (1_000, 10_000):
        tree.put("parent", "a", stamp * NS)
        tree.put("parent", "b", stamp * NS)
        tree.put("grandparent", "parent", stamp * NS)
        tree.put("great-grandparent", "grandparent", stamp * NS)
    tree.lookup("a", "b", 2_000 * NS)


def test_data_may_be_missing_above_the_common_parent(tree):
    for t in (1.0, 10.0):
        tree.put("parent", "a", t, (1, 0, 0))
        tree.put("parent", "b", t, (0, 1, 0))
    tree.put("world", "parent", 50.0)
    assert tree.lookup("a", "b", 5.0).translation == pytest.approx((-1, 1, 0))


def test_one_value_allows_no_extrapolation(tree):
    tree.put("parent", "a", 1_000 * NS)
    tree.put("grandparent", "parent", 1_000 * NS)
    for target in ("parent", "grandparent"):
        for outside in (10, 100_000):
            with pytest.raises(ExtrapolationException):
                tree.lookup(target, "a", outside * NS)
    tree.put("parent", "a", 20_000 * NS)
    tree.lookup("parent", "a", 10_000 * NS)


def test_a_repeated_time_gives_no_nan(tree):
    tree.put("parent", "child", 4.0)
    tree.put("parent", "child", 4.0, (1, 0, 0))
    found = tree.lookup("parent", "child", 4.0)
    assert not any(map(math.isnan, (*found.translation, *found.rotation)))


def test_texts_of_extrapolation(tree):
    tree.put("w", "a", 5.0)
    with pytest.raises(ExtrapolationException) as caught:
        tree.lookup("w", "a", 6.0)
    assert str(caught.value) == (
        "Lookup would require extrapolation at time 6.000000000, but only time 5.000000000 is in "
        "the buffer, when looking up transform from frame [a] to frame [w]"
    )
    tree.put("w", "a", 5.5)
    with pytest.raises(ExtrapolationException) as caught:
        tree.lookup("a", "w", 6.0)
    assert str(caught.value) == (
        "Lookup would require extrapolation 0.500000000s into the future.  Requested time "
        "6.000000000 but the latest data is at time 5.500000000, when looking up transform from "
        "frame [w] to frame [a]"
    )
    gap = caught.value.gap
    assert (gap.frame, gap.requested, gap.oldest, gap.newest, gap.missing) == (
        "a", 6 * 10**9, 5 * 10**9, 55 * 10**8, 5 * 10**8,
    )  # fmt: skip


def test_unconnected_trees_within_their_data_are_a_connectivity_error(tree):
    tree.put("w", "a", 1.0)
    tree.put("v", "b", 1.0)
    for t in (0.0, 1.0):
        with pytest.raises(ConnectivityException) as caught:
            tree.lookup("a", "b", t)
        assert str(caught.value) == (
            "Could not find a connection between 'a' and 'b' because they are not part of the "
            "same tree.Tf has two or more unconnected trees."
        )
    assert tree.core.can_transform("a", "b", time=10**9) == (False, str(caught.value))


def test_unconnected_trees_outside_their_data_are_an_extrapolation_error(tree):
    tree.put("w", "a", 1.0)
    tree.put("v", "b", 1.0)
    with pytest.raises(ExtrapolationException):
        tree.lookup("a", "b", 2.0)
    with pytest.raises(ExtrapolationException):
        tree.lookup("w", "b", 2.0)


def test_the_targets_lack_of_data_is_told_first(tree):
    for t in (1.0, 3.0):
        tree.put("w", "a", t)
    for t in (1.0, 2.0):
        tree.put("w", "b", t)
    with pytest.raises(ExtrapolationException) as caught:
        tree.lookup("a", "b", 4.0)
    assert caught.value.gap.frame == "a"
    with pytest.raises(ExtrapolationException) as caught:
        tree.lookup("b", "a", 4.0)
    assert caught.value.gap.frame == "b"


def test_the_latest_common_time_may_lie_before_a_links_data(tree):
    for t in (1.0, 3.0):
        tree.put("w", "a", t)
    for t in (5.0, 6.0):
        tree.put("a", "b", t)
    assert tree.core.latest_common_time("w", "b") == 3 * 10**9
    with pytest.raises(ExtrapolationException, match="into the past"):
        tree.lookup("w", "b")


def test_loop(tree):
    tree.put("b", "a", 1.0)
    tree.put("a", "b", 1.0)
    tree.put("w", "c", 1.0)
    for t in (0.0, 1.0):
        with pytest.raises(LookupException) as caught:
            tree.lookup("c", "a", t)
        assert str(caught.value) == (
            "The tf tree is invalid because it contains a loop.\n"
            "Frame a exists with parent b.\nFrame b exists with parent a.\n"
            "Frame c exists with parent w.\n\n"
        )


def test_a_loop_is_not_noticed_if_the_target_comes_first(tree):
    tree.put("b", "a", 1.0, (1, 0, 0))
    tree.put("a", "b", 1.0, (5, 0, 0))
    assert tree.lookup("b", "a", 1.0).translation == (1, 0, 0)


def test_the_way_to_the_root_may_have_a_thousand_links(tree):
    for i in range(1001):
        tree.put(f"f{i}", f"f{i + 1}", 1.0, (1, 0, 0))
    assert tree.lookup("f0", "f1000", 1.0).translation == (1000, 0, 0)
    assert tree.lookup("f0", "f1000").translation == (1000, 0, 0)
    tree.put("x", "elsewhere", 1.0)
    for t in (0.0, 1.0):
        with pytest.raises(LookupException, match="loop"):
            tree.lookup("elsewhere", "f1001", t)


# -- can_transform


@pytest.fixture
def siblings(tree):
    for t in range(10, 20):
        tree.put("parent", "child", t)
        tree.put("parent", "other_child", t)
    return tree


VALID, ZERO, OLD, FUTURE = 15.0, 0.0, 5.0, 25.0


@pytest.mark.parametrize(
    ("t", "expected"), [(VALID, True), (ZERO, True), (OLD, False), (FUTURE, False)]
)
def test_can_transform(siblings, t, expected):
    for target, source in (("child", "parent"), ("parent", "child"), ("child", "other_child")):
        assert siblings.can(target, source, t) is expected
        if expected:
            siblings.lookup(target, source, t)
        else:
            with pytest.raises(ExtrapolationException):
                siblings.lookup(target, source, t)
    for frame in ("child", "parent", "never-heard-of"):
        assert siblings.can(frame, frame, t)


@pytest.mark.parametrize("t_target", [VALID, ZERO, OLD, FUTURE])
@pytest.mark.parametrize(
    ("t_source", "expected"), [(VALID, True), (ZERO, True), (OLD, False), (FUTURE, False)]
)
def test_can_transform_full_fixed_in_the_target(siblings, t_target, t_source, expected):
    args = ("child", t_target, "parent", t_source, "child")
    assert siblings.can_full(*args) is expected
    if expected:
        siblings.full(*args)
    else:
        with pytest.raises(ExtrapolationException):
            siblings.full(*args)


@pytest.mark.parametrize("t_source", [VALID, ZERO, OLD, FUTURE])
@pytest.mark.parametrize(
    ("t_target", "expected"), [(VALID, True), (ZERO, True), (OLD, False), (FUTURE, False)]
)
def test_can_transform_full_fixed_in_the_source(siblings, t_target, t_source, expected):
    args = ("child", t_target, "parent", t_source, "parent")
    assert siblings.can_full(*args) is expected
    if expected:
        siblings.full(*args)
    else:
        with pytest.raises(ExtrapolationException):
            siblings.full(*args)


def test_full_lookup_tells_the_source_first_and_can_transform_the_target(siblings):
    with pytest.raises(ExtrapolationException, match=r"\[other_child\] to frame \[parent\]"):
        siblings.full("child", FUTURE, "other_child", FUTURE, "parent")
    _, reason = siblings.core.can_transform_full(
        "child", "other_child", target_time=25 * 10**9, source_time=25 * 10**9, fixed="parent"
    )
    assert reason.endswith("from frame [parent] to frame [child]")


def test_full_lookup_of_a_frame_in_its_own_past_is_its_motion(tree):
    tree.put("world", "turtle1", 5.0, (1, 0, 0))
    tree.put("world", "turtle1", 10.0, (4, 0, 0))
    found = tree.full("turtle1", 10.0, "turtle1", 5.0, "world")
    assert found.translation == pytest.approx((-3, 0, 0))
    assert found.stamp == 10 * 10**9


def test_full_lookup_takes_the_stamp_of_the_target_side(siblings):
    assert siblings.full("child", 0.0, "other_child", 15.0, "parent").stamp == 19 * 10**9


# -- what tf2 stores


def test_rotations_that_are_not_quite_unit_scale_in_a_chain_but_not_over_a_fixed_frame(tree):
    tree.put("a", "b", 1.0, (1, 0, 0), (0, 0, 0, 0.995))
    tree.put("b", "c", 1.0, (1, 0, 0))
    assert tree.lookup("a", "c").translation == pytest.approx((1.990025, 0, 0))
    assert tree.lookup("a", "b").rotation == (0, 0, 0, 0.995)
    found = tree.full("a", 1.0, "b", 1.0, "a")
    assert found.rotation == (0, 0, 0, 1)
    assert tree.full("a", 1.0, "c", 1.0, "b").translation == pytest.approx((2, 0, 0), abs=1e-12)


def test_antipodal_rotations_do_not_turn_in_between(tree):
    tree.put("a", "b", 1.0, q=(0, 0, 0, 1))
    tree.put("a", "b", 2.0, q=(0, 0, 0, -1))
    assert tree.lookup("a", "b", 1.5).rotation == (0, 0, 0, 1)


def test_the_first_transform_decides_whether_a_frame_is_static(tree):
    tree.put("w", "s", 1.0, (1, 0, 0), static=True)
    tree.put("w", "s", 2.0, (2, 0, 0))
    assert tree.lookup("w", "s", 99.0) == (Transform((2, 0, 0)), 99 * 10**9)
    tree.put("w", "d", 1.0, (1, 0, 0))
    tree.put("w", "d", 2.0, (2, 0, 0), static=True)
    assert tree.lookup("w", "d", 1.5).translation == (1.5, 0, 0)
    with pytest.raises(ExtrapolationException):
        tree.lookup("w", "d", 99.0)


def test_clear_keeps_names_and_static_frames(tree):
    tree.put("w", "s", 1.0, (1, 0, 0), static=True)
    tree.put("w", "d", 1.0)
    tree.core.clear()
    assert tree.lookup("w", "s", 5.0).translation == (1, 0, 0)
    assert tree.core.frame_strings == ["s", "w", "d"]
    assert tree.core.all_frames_as_string() == (
        "Frame s exists with parent w.\nFrame d exists with parent NO_PARENT.\n"
    )
    with pytest.raises(ConnectivityException):
        tree.lookup("w", "d")
    with pytest.raises(ExtrapolationException):
        tree.lookup("w", "d", 1.0)


def test_reparenting_follows_the_history(tree):
    tree.put("a", "x", 1.0, (1, 0, 0))
    tree.put("a", "x", 2.0, (2, 0, 0))
    tree.put("b", "x", 3.0, (3, 0, 0))
    tree.put("b", "x", 4.0, (4, 0, 0))
    assert tree.lookup("a", "x", 1.5).translation == (1.5, 0, 0)
    assert tree.lookup("a", "x", 2.5).translation == (2, 0, 0)
    assert tree.lookup("b", "x", 3.5).translation == (3.5, 0, 0)
    with pytest.raises(ConnectivityException):
        tree.lookup("a", "x", 3.5)


def test_get_parent(tree):
    links = {"a": "c", "b": "c", "c": "e", "d": "e", "e": "f", "f": "j", "/k": "l"}
    for child, parent in links.items():
        tree.put(parent, child, 10 * NS)
    for child, parent in links.items():
        assert tree.core.parent_of(child.removeprefix("/"), time=10) == parent
    assert tree.core.parent_of("j", time=10) is None
    assert tree.core.parent_of("unknown", time=10) is None


def test_frames_are_listed_in_the_order_of_their_appearance(tree):
    tree.put("parent", "b", 1.0)
    tree.put("frame", "other", 1.0)
    assert tree.core.frame_strings == ["b", "parent", "other", "frame"]
    assert tree.core.frame_exists("parent")
    assert not tree.core.frame_exists("nope")


def test_cache_length(tools):
    for seconds in range(2, 98):
        tree = tools.Tree(cache_time=seconds)
        for t in range(101):
            tree.put("w", "a", t)
        assert tree.core.frames.caches[1].span == ((100 - seconds) * 10**9, 100 * 10**9)
        for t in {1, 99 - seconds} - {0}:
            with pytest.raises(ExtrapolationException):
                tree.lookup("w", "a", t)
        for t in (100 - seconds, 99):
            assert tree.lookup("w", "a", t).stamp == t * 10**9


def test_stamps_out_of_order(tree):
    stamps = [3, 5, 10, 11, 19, 20, 21]
    newest = 0
    for t in stamps:
        newest = max(newest, t)
        tree.put("w", "a", t)
        assert tree.core.latest_common_time("w", "a") == newest * 10**9
    with pytest.raises(ExtrapolationException):
        tree.lookup("w", "a", 2.0)


def test_the_order_of_arrival_makes_no_difference(tools):
    import random

    samples = [(t, (float(t), float(t * t), 0.0)) for t in range(1, 9)]
    forward, shuffled = tools.Tree(), tools.Tree()
    for t, xyz in samples:
        forward.put("w", "a", t, xyz)
    random.Random(3).shuffle(samples)
    for t, xyz in samples:
        shuffled.put("w", "a", t, xyz)
    for k in range(10, 81):
        assert forward.lookup("w", "a", k / 10) == shuffled.lookup("w", "a", k / 10)
