from __future__ import annotations

import html
import re

import pytest

from simkit.errors import UnknownNameError
from simkit.viz import RvizReplay, RvizSettings, WorldReplay, WorldSettings, WorldTape


@pytest.fixture
def replay(drive):
    return RvizReplay(drive)


def test_it_has_a_button_a_slider_and_speeds(replay, read_page):
    page = read_page(replay.to_html())
    assert page.by_id("play")[0] == "button"
    _, slider = page.by_id("time")
    assert (slider["type"], slider["min"], slider["max"], slider["value"]) == (
        *("range", "0", "2.000", "2.000"),
    )
    assert [a["value"] for tag, a in page.tags if tag == "option"][2] == "1"


def test_its_script_finds_few_rows(replay, read_page):
    tape = read_page(replay.to_html()).data["tape"]
    assert tape["duration"] == 2.0
    identity = [0, 0, 0, 1]
    assert tape["tracks"] == [
        {"until": None, "rows": [[0.0, 0, 0, 0, *identity], [2.0, 0, 0, 0, *identity]]},
        {"until": None, "rows": [[0.0, 0, 0, 0, *identity], [2.0, 2, 0, 0, *identity]]},
    ]


def test_equal_recordings_give_equal_bytes(replay, drive):
    assert replay.to_html() == RvizReplay(drive, RvizSettings()).to_html()


def test_where_frames_are_left_out_its_end_is_seen(replay, tape):
    for one in (replay, WorldReplay(tape)):
        assert one._repr_png_().startswith(b"\x89PNG")
        before_the_frame = one._repr_html_().partition("<iframe")[0]
        assert 'src="data:image/png;base64,' in before_the_frame


def test_it_is_shown_in_a_notebook_and_saved(replay, tmp_path):
    (source,) = re.findall(r'srcdoc="([^"]*)"', replay._repr_html_())
    assert html.unescape(source) == replay.to_html()
    replay.save(tmp_path / "run.html")
    assert (tmp_path / "run.html").read_text(encoding="utf-8") == replay.to_html()
    with pytest.raises(UnknownNameError, match=r"no replay format '\.mp4'"):
        replay.save(tmp_path / "run.mp4")
    assert repr(replay) == "RvizReplay(2.00 s, 2 frames)"


@pytest.fixture
def tape(sim, cart):
    tape = WorldTape(sim.gazebo, sim.gazebo.node)
    cart.model.set_twist((2.0, 0.0, 0.0), (0.0, 0.0, 0.0))
    sim.run(0.5)
    return tape


def test_it_is_one_page_that_needs_nothing_else(tape, read_page):
    page = read_page(WorldReplay(tape, WorldSettings(contacts=True), trails=["cart"]).to_html())
    assert page.by_id("play")[0] == "button"
    assert page.by_id("time")[1]["max"] == "0.500"
    data = page.data["tape"]
    assert [len(data[name]) for name in ("tracks", "marks")] == [3, 2]
    assert [track["until"] for track in data["tracks"]] == [None] * 3
    assert page.by_id("marks-contacts")[0] == page.by_id("marks-trail-0")[0] == "input"


def test_equal_recordings_give_equal_bytes_replay(tape):
    assert WorldReplay(tape).to_html() == WorldReplay(tape).to_html()


def test_it_does_not_change_when_the_recording_goes_on(sim, tape):
    replay = WorldReplay(tape)
    before = replay.to_html()
    sim.run(0.2)
    assert replay.to_html() == before
    assert WorldReplay(tape).tape.duration == pytest.approx(0.7)


def test_it_is_shown_in_a_notebook_and_saved_replay(tape, tmp_path):
    replay = WorldReplay(tape)
    (source,) = re.findall(r'srcdoc="([^"]*)"', replay._repr_html_())
    assert html.unescape(source) == replay.to_html()
    replay.save(tmp_path / "run.html")
    assert (tmp_path / "run.html").read_text(encoding="utf-8") == replay.to_html()
    with pytest.raises(UnknownNameError, match=r"no replay format '\.mp4'"):
        replay.save(tmp_path / "run.mp4")
    assert repr(replay) == "WorldReplay(0.50 s, 3 links)"
