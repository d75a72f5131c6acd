from __future__ import annotations

from simkit.msgs import Time
from simkit.viz.forest import forest_of
from simkit.viz.frames_dot import dot_text

NOW = Time(1600088402)


def test_one_tree_has_the_form_of_tf2_tools(buffer):
    buffer.put("world", "turtle1", 1600088400.0)
    buffer.put("world", "turtle1", 1600088401.0)
    assert dot_text(forest_of(buffer.core), NOW) == (
        "digraph G {\n"
        '"world" -> "turtle1"[label=" Broadcaster: /me\\nAverage rate: 2.000\\n'
        "Buffer length: 1.000\\nMost recent transform: 1600088401.000\\n"
        'Oldest transform: 1600088400.000\\n"];\n'
        "edge [style=invis];\n"
        ' subgraph cluster_legend { style=bold; color=black; label ="view_frames Result";\n'
        '"Recorded at time: 1600088402.000"[ shape=plaintext ] ;\n'
        ' }->"world";\n'
        "}"
    )


def test_the_legend_points_at_every_root(two_trees):
    assert '}->{"world"; "map"};' in dot_text(forest_of(two_trees.core), NOW)


def test_without_a_time_there_is_no_legend(turtles):
    text = dot_text(forest_of(turtles.core), None)
    assert "subgraph" not in text
    assert text.count("->") == 3


def test_quotes_in_names_do_not_end_the_name(buffer):
    buffer.put('a"b\\', "c")
    assert '"a\\"b\\\\" -> "c"' in dot_text(forest_of(buffer.core), None)


def test_nothing(buffer):
    assert dot_text(forest_of(buffer.core), NOW) == 'digraph G { "No tf data received" }'
