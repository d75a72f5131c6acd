from __future__ import annotations

import re
import xml.etree.ElementTree as ET

import pytest
import yaml

from simkit.errors import UnknownNameError
from simkit.msgs import Time
from simkit.viz import FramesPicture
from simkit.viz.trees.forest import forest_of
from simkit.viz.trees.frames import dot_text

SVG = "{http://www.w3.org/2000/svg}"
NOW = Time(1600088402)


def test_the_tree_with_its_facts(turtles, texts):
    shown = texts(FramesPicture(turtles, now=NOW).to_svg())
    assert shown[:3] == [
        "view_frames Result",
        "Recorded at time: 1600088402.000",
        "4 frames in 1 tree",
    ]
    assert {"world", "turtle1", "turtle2", "carrot1"} < set(shown)
    assert shown.count("Most recent transform") == 3


def test_facts_are_those_of_the_yaml(two_trees, texts):
    picture = FramesPicture(two_trees)
    shown = texts(picture.to_svg())
    facts = yaml.safe_load(picture.to_yaml())
    assert picture.to_yaml() == two_trees.all_frames_as_yaml()
    assert len(facts) == 6
    for frame, fact in facts.items():
        group = f"{fact['parent']} -> {frame}: "
        (title,) = re.findall(
            rf"<title>({group.replace('>', '&gt;')}[^<]*)</title>", picture.to_svg()
        )
        for name, key in (
            ("Average rate", "rate"),
            ("Buffer length", "buffer_length"),
            ("Most recent transform", "most_recent_transform"),
            ("Oldest transform", "oldest_transform"),
        ):
            assert f"{name}: {fact[key]:.3f}" in title
            assert f"{fact[key]:.3f}" in shown
        assert f"Broadcaster: {fact['broadcaster']}" in title


def test_two_trees_stand_side_by_side_with_a_sentence(two_trees, texts):
    picture = FramesPicture(two_trees)
    shown = " ".join(texts(picture.to_svg()))
    assert "8 frames in 2 trees" in shown
    assert "These trees are not connected." in shown
    assert picture.warnings[0] in shown
    rectangles = ET.fromstring(picture.to_svg()).findall(f"{SVG}rect")
    panels = [box for box in rectangles if box.attrib["fill"] == "#f7f9fc"]
    left, right = (float(box.attrib["x"]) for box in panels)
    assert left + float(panels[0].attrib["width"]) < right


def test_static_transforms_are_broken_lines_with_a_key(two_trees, turtles, texts):
    svg = FramesPicture(two_trees).to_svg()
    assert "stroke-dasharray" in svg
    assert any("static transform" in text for text in texts(svg))


def test_everything_lies_on_the_page(two_trees, hostile):
    for buffer in (two_trees, hostile):
        root = ET.fromstring(FramesPicture(buffer).to_svg())
        width, height = float(root.attrib["width"]), float(root.attrib["height"])
        for box in root.iter(f"{SVG}rect"):
            x, y = float(box.attrib.get("x", 0)), float(box.attrib.get("y", 0))
            assert x >= 0
            assert y >= 0
            assert x + float(box.attrib["width"]) <= width
            assert y + float(box.attrib["height"]) <= height


def test_a_wide_tree_grows_sideways(buffer):
    for number in range(20):
        buffer.put("base_link", f"wheel_{number}")
    root = ET.fromstring(FramesPicture(buffer).to_svg())
    assert float(root.attrib["width"]) < 700 < float(root.attrib["height"])


def test_hostile_names_are_only_names(hostile, texts):
    picture = FramesPicture(hostile, now=NOW)
    svg = picture.to_svg()
    shown = texts(svg)
    assert "<script>alert(1)</script>" in shown
    assert "<i>node</i>" in shown
    assert "<script" not in svg
    assert max(map(len, shown)) < 200
    assert picture.to_png().startswith(b"\x89PNG")
    assert picture.to_pdf().startswith(b"%PDF")


def test_nothing_received(buffer, texts):
    picture = FramesPicture(buffer, now=NOW)
    assert texts(picture.to_svg())[-1] == "No tf data received"
    assert picture.to_dot() == 'digraph G { "No tf data received" }'
    assert picture.to_yaml() == "{}"
    assert picture.to_png().startswith(b"\x89PNG")


def test_equal_buffers_give_equal_bytes(two_trees):
    one, two = FramesPicture(two_trees, now=NOW), FramesPicture(two_trees, now=NOW)
    assert one.to_svg() == two.to_svg()
    assert one.to_pdf() == two.to_pdf()
    assert one.to_png(scale=1) == two.to_png(scale=1)


def test_a_picture_does_not_change_afterwards(turtles):
    picture = FramesPicture(turtles)
    before = picture.to_svg(), picture.to_yaml(), picture.to_dot()
    turtles.put("world", "turtle3", by="/late")
    assert (picture.to_svg(), picture.to_yaml(), picture.to_dot()) == before


def test_save_writes_by_suffix(turtles, tmp_path):
    picture = FramesPicture(turtles)
    for suffix in (".svg", ".gv", ".yaml", ".png", ".PDF"):
        picture.save(tmp_path / f"frames{suffix}")
    assert (tmp_path / "frames.svg").read_text(encoding="utf-8") == picture.to_svg()
    assert (tmp_path / "frames.gv").read_text(encoding="utf-8") == picture.to_dot()
    assert (tmp_path / "frames.yaml").read_text(encoding="utf-8") == picture.to_yaml()
    assert (tmp_path / "frames.PDF").read_bytes() == picture.to_pdf()
    with pytest.raises(UnknownNameError, match=r"no picture format '\.jpg'"):
        picture.save(str(tmp_path / "frames.jpg"))


def test_notebooks_show_it(turtles):
    picture = FramesPicture(turtles)
    assert picture._repr_svg_() == picture.to_svg()
    assert repr(picture) == "FramesPicture(4 frames, 1 trees)"


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
