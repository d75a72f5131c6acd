"""The history of one frame: numbers are those of tf2's own cache tests."""

from __future__ import annotations

import math
import random

import pytest

from simkit.geometry import IDENTITY, ORIGIN, Quaternion, slerp
from simkit.tf.cache import LATEST, StaticCache, TimeCache

LENGTH = 10 * 10**9


def edge(parent, translation=ORIGIN, rotation=IDENTITY):
    return (parent, translation, rotation)


def random_rotation(rng: random.Random) -> Quaternion:
    values = [rng.gauss(0.0, 1.0) for _ in range(4)]
    norm = math.sqrt(sum(v * v for v in values))
    x, y, z, w = (v / norm for v in values)
    return (x, y, z, w)


@pytest.mark.parametrize("stamps", [range(1, 100), range(99, 0, -1)])
def test_each_stamp_gives_its_own_sample(stamps):
    cache = TimeCache(LENGTH)
    for stamp in stamps:
        assert cache.insert(stamp, edge(stamp)) == ""
    assert [cache.at(i) for i in range(1, 100)] == [edge(i) for i in range(1, 100)]


def test_zero_asks_for_the_newest():
    cache = TimeCache(LENGTH)
    for stamp in range(1, 101):
        cache.insert(stamp, edge(stamp))
    assert cache.at(LATEST) == edge(100)
    cache.insert(101, edge(101))
    assert cache.at(LATEST) == edge(101)
    assert [cache.at(i) for i in range(1, 102)] == [edge(i) for i in range(1, 102)]


def test_position_between_two_samples_is_linear():
    rng = random.Random(1)
    cache = TimeCache(LENGTH)
    start = tuple(rng.uniform(-100, 100) for _ in range(3))
    end = tuple(rng.uniform(-100, 100) for _ in range(3))
    cache.insert(200, edge(2, start))
    cache.insert(300, edge(2, end))
    for pos in range(101):
        expected = [a + (b - a) * pos / 100.0 for a, b in zip(start, end, strict=True)]
        assert cache.at(200 + pos)[1] == pytest.approx(expected, abs=1e-12)


def test_rotation_between_two_samples_is_slerp():
    rng = random.Random(2)
    start, end = random_rotation(rng), random_rotation(rng)
    cache = TimeCache(LENGTH)
    cache.insert(200, edge(3, rotation=start))
    cache.insert(300, edge(3, rotation=end))
    for pos in range(101):
        expected = end if pos == 100 else slerp(start, end, pos / 100.0)
        assert cache.at(200 + pos)[2] == pytest.approx(expected, abs=1e-12)


def test_at_a_stamp_nothing_is_computed():
    rng = random.Random(3)
    cache = TimeCache(LENGTH)
    samples = {t: edge(2, (math.inf, 0.1, t / 3), random_rotation(rng)) for t in (10, 20, 30)}
    for t, sample in samples.items():
        cache.insert(t, sample)
    for t, sample in samples.items():
        assert cache.at(t) == sample


def test_no_interpolation_across_a_change_of_parent():
    cache = TimeCache(LENGTH)
    first = edge(4, (1.0, 2.0, 3.0))
    cache.insert(555, first)
    cache.insert(655, edge(5, (9.0, 9.0, 9.0)))
    assert {cache.at(555 + pos) for pos in range(100)} == {first}
    assert cache.at(655)[0] == 5


def test_a_repeated_stamp_is_refused_and_the_first_value_stays():
    cache = TimeCache(LENGTH)
    assert cache.insert(1, edge(3)) == ""
    assert cache.insert(1, edge(4)).startswith("TF_REPEATED_DATA ")
    assert cache.at(1) == edge(3)
    assert len(cache) == 1


def test_what_is_exactly_as_old_as_the_cache_is_long_still_goes_in():
    cache = TimeCache(100)
    cache.insert(200, edge(1))
    assert cache.insert(99, edge(2)).startswith("TF_OLD_DATA ")
    assert cache.insert(100, edge(3)) == ""
    assert cache.span == (100, 200)


def test_what_is_exactly_as_old_as_the_cache_is_long_stays():
    cache = TimeCache(100)
    for stamp in (1, 50, 101):
        cache.insert(stamp, edge(stamp))
    assert cache.span == (1, 101)
    cache.insert(102, edge(102))
    assert cache.span == (50, 102)


def test_outside_the_data_there_is_nothing():
    cache = TimeCache(LENGTH)
    for stamp in (10, 20):
        cache.insert(stamp, edge(1))
    assert cache.at(9) is None
    assert cache.at(21) is None


def test_texts_of_refusals():
    cache = TimeCache(LENGTH)
    assert cache.refusal(5) == ""
    cache.insert(3 * 10**9, edge(1))
    assert cache.refusal(4 * 10**9) == (
        "Lookup would require extrapolation at time 4.000000000, "
        "but only time 3.000000000 is in the buffer"
    )
    cache.insert(5 * 10**9, edge(1))
    assert cache.refusal(5_500_000_001) == (
        "Lookup would require extrapolation 0.500000001s into the future.  "
        "Requested time 5.500000001 but the latest data is at time 5.000000000"
    )
    assert cache.refusal(10**9) == (
        "Lookup would require extrapolation 2.000000000s into the past.  "
        "Requested time 1.000000000 but the earliest data is at time 3.000000000"
    )


def test_texts_keep_every_nanosecond_of_todays_date():
    cache = TimeCache(LENGTH)
    cache.insert(1_600_088_400_123_456_789, edge(1))
    assert "only time 1600088400.123456789 is" in cache.refusal(1)


def test_clear_empties():
    cache = TimeCache(LENGTH)
    cache.insert(1, edge(1))
    cache.clear()
    assert cache.at(LATEST) is None
    assert not cache
    assert cache.newest_link == (0, 0)


# -- a frame that never moves


def test_the_last_transform_holds_at_every_time():
    cache = StaticCache()
    for i in range(1, 101):
        assert cache.insert(i, (i, ORIGIN, IDENTITY)) == ""
        assert cache.at(i) == (i, ORIGIN, IDENTITY)
    assert cache.at(1) == cache.at(10**18) == (100, ORIGIN, IDENTITY)
    assert len(cache) == 1


def test_a_repeated_stamp_replaces():
    cache = StaticCache()
    cache.insert(1, (3, ORIGIN, IDENTITY))
    cache.insert(1, (4, ORIGIN, IDENTITY))
    assert cache.at(1) == (4, ORIGIN, IDENTITY)


def test_it_has_no_stamps_and_survives_a_clear():
    cache = StaticCache()
    cache.insert(77, (2, ORIGIN, IDENTITY))
    cache.clear()
    assert cache.newest_link == (0, 2)
    assert cache.span == (0, 0)
