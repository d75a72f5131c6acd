from __future__ import annotations

import html
import re

import pytest

from simkit.errors import UnknownNameError
from simkit.nodes.turtlesim import Frame
from simkit.viz import TurtleReplay


@pytest.fixture
def replay(window):
    window.drive(1.0, 0.5)
    window.run(1.0)
    window.call("/spawn", "turtlesim/Spawn", x=2, y=3, theta=0, name="ann")
    window.run(2.0)
    window.call("/kill", "turtlesim/Kill", name="ann")
    window.run(1.0)
    return TurtleReplay(window.frame)


def test_it_has_a_window_a_button_a_slider_and_speeds(replay, read_page):
    page = read_page(replay.to_html())
    assert page.by_id("play")[0] == "button"
    _, slider = page.by_id("time")
    assert (slider["type"], slider["min"], slider["max"]) == ("range", "0", "3.968")
    assert slider["value"] == slider["max"]
    assert slider["aria-label"]
    assert [a["value"] for tag, a in page.tags if tag == "option"][2] == "1"
    assert page.by_id("window")[1]["aria-label"].startswith("turtlesim with 2 turtles")


def test_without_a_script_it_shows_the_end(replay, window, read_page):
    page = read_page(replay.to_html())
    (line,) = [a for tag, a in page.tags if tag == "polyline" and a["stroke"] == "#b3b8ff"]
    x, y = (float(value) for value in line["points"].split()[-1].split(","))
    pose = window.frame.turtle("turtle1").pose
    assert (x - 0.5) / 45 == pytest.approx(pose.x, abs=0.01)
    assert (499 + 0.5 - y) / 45 == pytest.approx(pose.y, abs=0.02)
    turtles = [a for tag, a in page.tags if a.get("class") == "turtle"]
    assert [a.get("style") for a in turtles] == ["display:none", None]


def test_data_for_the_script_are_the_tape(replay, read_page):
    data = read_page(replay.to_html()).data
    tape = replay.tape
    assert data["duration"] == tape.duration
    assert len(data["turtles"]) == len(tape.motions) == 2
    assert data["turtles"][0]["until"] == pytest.approx(2.96, abs=0.02)
    assert data["turtles"][1]["rows"][-1] == pytest.approx(tape.motions[1].rows[-1], abs=0.006)
    assert data["sheets"][0]["trails"][0]["rows"][0] == pytest.approx(
        tape.sheets[0].trails[0].rows[0], abs=0.006
    )


def test_a_minute_of_driving_is_a_small_file(window):
    window.drive(1.5, 0.6)
    window.run(60)
    assert len(TurtleReplay(window.frame).to_html()) < 60_000


def test_odd_names_are_only_names(read_page):
    frame = Frame()
    frame.spawn("</text><script>\x00", x=1, y=1)
    frame.update(16_000_000)
    page = read_page(TurtleReplay(frame).to_html())
    assert len(page.scripts) == 2
    assert page.texts.count("</text><script>\ufffd") == 2


def test_equal_runs_give_equal_text_and_later_moves_change_nothing(replay, window):
    text = replay.to_html()
    assert TurtleReplay(window.frame).to_html() == text
    window.run(1.0)
    assert replay.to_html() == text
    assert TurtleReplay(window.frame).to_html() != text


def test_before_the_first_update_it_is_an_empty_window(window, read_page):
    page = read_page(TurtleReplay(window.frame).to_html())
    assert page.data["turtles"] == []
    assert page.data["duration"] == 0.0


def test_notebooks_show_it_and_files_hold_it(replay, tmp_path):
    (source,) = re.findall(r'srcdoc="([^"]*)"', replay._repr_html_())
    assert html.unescape(source) == replay.to_html()
    assert repr(replay) == "TurtleReplay(3.97 s, 2 turtles)"
    replay.save(tmp_path / "run.html")
    assert (tmp_path / "run.html").read_text(encoding="utf-8") == replay.to_html()
    with pytest.raises(UnknownNameError, match=r"no replay format '\.gif'"):
        replay.save(str(tmp_path / "run.gif"))


def test_where_frames_are_stripped_the_end_is_seen(window):
    window.drive(1.0)
    window.run(1.0)
    replay = TurtleReplay(window.frame)
    svg = replay._repr_svg_()
    assert "turtle1" in svg
    window.run(1.0)
    assert replay._repr_svg_() == svg
