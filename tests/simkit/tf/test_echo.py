"""What tf_echo prints."""

from __future__ import annotations

import math

import pytest

from simkit.msgs import Time
from simkit.tf import Buffer, Transform, echo_text, in_words

NOW = Time(1600088412, 34000000)


@pytest.fixture
def buffer(stamped, yaw):
    buffer = Buffer()
    buffer.set_transform(stamped("world", "turtle1", 12.5, (1.0, -2.0, 0.0), yaw(math.pi / 6)))
    buffer.set_transform(stamped("turtle1", "carrot1", 12.0, (0.0, 2.0, 0.0)))
    return buffer


def test_block(buffer):
    assert echo_text(buffer, "world", "turtle1", NOW) == (
        "At time 12.500\n"
        "- Translation: [1.000, -2.000, 0.000]\n"
        "- Rotation: in Quaternion [0.000, 0.000, 0.259, 0.966]\n"
        "            in RPY (radian) [0.000, -0.000, 0.524]\n"
        "            in RPY (degree) [0.000, -0.000, 30.000]\n"
    )


def test_precision_and_slashes(buffer):
    text = echo_text(buffer, "/turtle1", "/carrot1", NOW, 1)
    assert text.startswith("At time 12.0\n- Translation: [0.0, 2.0, 0.0]\n")


def test_pitch_of_the_rounded_right_angle_turns_the_others_over(stamped):
    buffer = Buffer()
    half = 1.5708 / 2
    buffer.set_transform(stamped("a", "b", 1.0, q=(0, math.sin(half), 0, math.cos(half))))
    assert "in RPY (radian) [3.142, 1.571, 3.142]\n" in echo_text(buffer, "a", "b", NOW)


def test_the_quaternion_is_that_of_the_matrix(stamped):
    buffer = Buffer()
    buffer.set_transform(stamped("a", "b", 1.0, q=(0, 0, 0, -0.998)))
    assert "in Quaternion [0.000, 0.000, 0.000, 1.000]\n" in echo_text(buffer, "a", "b", NOW)


def test_failure(buffer):
    assert echo_text(buffer, "world", "/nobody", NOW) == (
        "Failure at 1600088412.034000000\n"
        'Exception thrown:"nobody" passed to lookupTransform argument source_frame does not '
        "exist. \n"
        "The current list of frames is:\n"
        "Frame turtle1 exists with parent world.\nFrame carrot1 exists with parent turtle1.\n"
        "\n"
    )


# -- a pose in words


def test_where_and_how_turned(yaw):
    pose = Transform((1.2, 0.3, 0.0), yaw(math.pi / 6))
    assert in_words("turtle2", "turtle1", pose) == (
        '"turtle1" seen from "turtle2": 1.200 m ahead, 0.300 m left; turned 30.0° to the left'
    )


def test_all_directions():
    q = (-math.sin(0.1), 0.0, 0.0, math.cos(0.1))
    assert in_words("a", "b", Transform((-1.0, -2.0, -3.0), q)) == (
        '"b" seen from "a": 1.000 m behind, 2.000 m right, 3.000 m down; rolled 11.5° to the left'
    )


def test_nothing():
    assert in_words("a", "b", Transform((0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0))) == (
        '"b" seen from "a": at the same place; not turned'
    )
