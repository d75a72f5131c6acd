"""A frame that never moves."""

from __future__ import annotations

from simkit.geometry import IDENTITY, ORIGIN
from simkit.tf.static_cache import StaticCache


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
