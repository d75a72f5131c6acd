"""What a buffer holds, as text."""

from __future__ import annotations

import pytest


@pytest.fixture
def scene(tree):
    for k in range(11):
        tree.put("world", "turtle1", 100.0 + k / 10, (k, 0, 0), authority="/turtle_tf_broadcaster")
    tree.put("turtle1", "carrot1", 0.0, (0, 2, 0), static=True, authority="/fixed")
    return tree.core


def test_lines(scene):
    assert scene.all_frames_as_string() == (
        "Frame turtle1 exists with parent world.\nFrame carrot1 exists with parent turtle1.\n"
    )


def test_yaml(scene):
    assert scene.all_frames_as_yaml() == (
        "turtle1: \n"
        "  parent: 'world'\n"
        "  broadcaster: '/turtle_tf_broadcaster'\n"
        "  rate: 11.000\n"
        "  most_recent_transform: 101.000\n"
        "  oldest_transform: 100.000\n"
        "  buffer_length: 1.000\n"
        "carrot1: \n"
        "  parent: 'turtle1'\n"
        "  broadcaster: '/fixed'\n"
        "  rate: 10000.000\n"
        "  most_recent_transform: 0.000\n"
        "  oldest_transform: 0.000\n"
        "  buffer_length: 0.000\n"
    )


def test_yaml_with_ages(scene):
    lines = scene.all_frames_as_yaml(101.25).splitlines()
    assert lines[6:8] == ["  transform_delay: 0.250", "  buffer_length: 1.000"]


def test_yaml_of_nothing(tree):
    assert tree.core.all_frames_as_yaml() == "{}"


def test_dot(scene):
    assert scene.all_frames_as_dot() == (
        "digraph G {\n"
        '"world" -> "turtle1"[label="Broadcaster: /turtle_tf_broadcaster\\n'
        "Average rate: 11.000 Hz\\nMost recent transform: 101.000 \\n"
        'Buffer length: 1.000 sec\\n"];\n'
        '"turtle1" -> "carrot1"[label="Broadcaster: /fixed\\n'
        "Average rate: 10000.000 Hz\\nMost recent transform: 0.000 \\n"
        'Buffer length: 0.000 sec\\n"];\n'
        "}"
    )


def test_dot_with_time(tree):
    tree.put("world", "a", 100.0)
    assert tree.core.all_frames_as_dot(101.5) == (
        "digraph G {\n"
        '"world" -> "a"[label="Broadcaster: me\\nAverage rate: 10000.000 Hz\\n'
        'Most recent transform: 100.000 ( 1.500 sec old)\\nBuffer length: 0.000 sec\\n"];\n'
        "edge [style=invis];\n"
        ' subgraph cluster_legend { style=bold; color=black; label ="view_frames Result";\n'
        '"Recorded at time: 101.500"[ shape=plaintext ] ;\n }->"world";\n'
        "}"
    )


def test_dot_of_nothing(tree):
    assert tree.core.all_frames_as_dot() == 'digraph G {\n"no tf data recieved"}'


def test_a_cleared_frame_is_a_root_in_dot(tree):
    tree.put("world", "a", 100.0)
    tree.core.clear()
    assert '}->"a";\n}' in tree.core.all_frames_as_dot()
    assert tree.core.all_frames_as_yaml() == ""
