from __future__ import annotations

import html
import re

import pytest

from simkit.errors import UnknownNameError
from simkit.msgs import Time
from simkit.viz import FramesView


def test_the_page_has_a_canvas_and_the_same_as_a_table(turtles, read_page):
    page = read_page(FramesView(turtles).to_html())
    _, canvas = page.by_id("scene")
    assert canvas["tabindex"] == "0"
    assert canvas["aria-label"].startswith("4 frames seen from world.")
    assert canvas["aria-describedby"] == "numbers"
    assert page.by_id("numbers")[0] == "table"
    shown = [text.strip() for text in page.texts if text.strip()]
    place = shown.index("turtle2", shown.index("yaw [°]"))
    assert shown[place : place + 8] == [
        "turtle2",
        "world",
        "3.625",
        "3.500",
        *["0.000"],
        *["0.0"] * 3,
    ]


def test_data_for_the_canvas_are_the_poses(turtles, read_page):
    data = read_page(FramesView(turtles).to_html()).data
    frames = {frame["label"]: frame for frame in data["frames"]}
    assert [frame["parent"] for frame in data["frames"]] == [None, 0, 1, 0]
    assert frames["world"]["isFixed"]
    assert not frames["turtle1"]["isFixed"]
    found = turtles.core.lookup("world", "carrot1")
    assert frames["carrot1"]["origin"] == pytest.approx(found.translation, abs=1e-6)
    assert frames["turtle2"]["axes"] == [[1, 0, 0], [0, 1, 0], [0, 0, 1]]


def test_what_is_wrong_is_said(two_trees, read_page):
    view = FramesView(two_trees)
    assert len(view.problems) == 4
    assert set(view.problems) < set(read_page(view.to_html()).texts)


def test_an_unknown_fixed_frame(turtles, read_page, texts):
    view = FramesView(turtles, "wrold")
    page = read_page(view.to_html())
    assert view.error in page.texts
    assert page.data["frames"] == []
    assert "numbers" not in [attributes.get("id") for _, attributes in page.tags]
    assert any("does not exist" in text for text in texts(view.to_svg()))


def test_nothing_received(buffer, read_page, texts):
    view = FramesView(buffer)
    assert view.error.startswith("No tf data.")
    assert view.error in read_page(view.to_html()).texts
    assert any(text.startswith("No tf data.") for text in texts(view.to_svg()))
    assert view.to_png().startswith(b"\x89PNG")


def test_the_still_picture_names_every_frame(two_trees, texts):
    shown = texts(FramesView(two_trees, "map").to_svg())
    assert {"map", "odom", "base_link", "laser", "Fixed Frame: map", "grid: 0.5 m"} < set(shown)
    assert any("No transform from [world] to [map]" in text for text in shown)


def test_another_time_is_another_view(turtles):
    early = FramesView(turtles, time=Time(1_600_088_400))
    assert early.to_html() != FramesView(turtles).to_html()


def test_hostile_names_are_only_names(hostile, read_page, texts):
    view = FramesView(hostile, "wörld")
    page = read_page(view.to_html())
    assert len(page.scripts) == 2
    assert "<script>alert(1)</script>" in page.texts
    assert "<script>alert(1)</script>" in texts(view.to_svg())
    assert view.to_png().startswith(b"\x89PNG")
    bad = FramesView(hostile, "</script><script>alert(2)</script>")
    assert len(read_page(bad.to_html()).scripts) == 2
    bad.to_html().encode("utf-8")


def test_equal_buffers_give_equal_bytes_and_later_frames_change_nothing(turtles):
    one, two = FramesView(turtles), FramesView(turtles)
    before = one.to_html(), one.to_svg(), one.to_png(scale=1)
    assert (two.to_html(), two.to_svg(), two.to_png(scale=1)) == before
    turtles.put("world", "turtle3")
    assert (one.to_html(), one.to_svg()) == before[:2]


def test_notebooks_show_it_in_a_frame_of_its_own(two_trees):
    view = FramesView(two_trees)
    shown = view._repr_html_()
    (source,) = re.findall(r'srcdoc="([^"]*)"', shown)
    assert html.unescape(source) == view.to_html()
    assert len(view.to_html()) < 30_000
    assert repr(view) == "FramesView('4 frames seen from world.')"


def test_save_writes_by_suffix(turtles, tmp_path):
    view = FramesView(turtles)
    for suffix in (".html", ".svg", ".png"):
        view.save(tmp_path / f"tf{suffix}")
    assert (tmp_path / "tf.html").read_text(encoding="utf-8") == view.to_html()
    assert (tmp_path / "tf.svg").read_text(encoding="utf-8") == view.to_svg()
    assert (tmp_path / "tf.png").read_bytes() == view.to_png()
    with pytest.raises(UnknownNameError, match=r"no picture format '\.gif'"):
        view.save(str(tmp_path / "tf.gif"))


def test_a_storm_of_frames_is_drawn_without_all_their_names(buffer, texts):
    for number in range(1500):
        buffer.put("world", f"f{number}", xyz=(number % 40, number // 40, 0))
    shown = texts(FramesView(buffer).to_svg())
    assert 100 < len(shown) < 250
