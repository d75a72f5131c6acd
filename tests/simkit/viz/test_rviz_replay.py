from __future__ import annotations

import html
import re

import pytest

from simkit.errors import UnknownNameError
from simkit.viz import RvizReplay, RvizSettings


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
        [[0.0, 0, 0, 0, *identity], [2.0, 0, 0, 0, *identity]],
        [[0.0, 0, 0, 0, *identity], [2.0, 2, 0, 0, *identity]],
    ]


def test_equal_recordings_give_equal_bytes(replay, drive):
    assert replay.to_html() == RvizReplay(drive, RvizSettings()).to_html()


def test_it_is_shown_in_a_notebook_and_saved(replay, tmp_path):
    (source,) = re.findall(r'srcdoc="([^"]*)"', replay._repr_html_())
    assert html.unescape(source) == replay.to_html()
    replay.save(tmp_path / "run.html")
    assert (tmp_path / "run.html").read_text(encoding="utf-8") == replay.to_html()
    with pytest.raises(UnknownNameError, match=r"no replay format '\.mp4'"):
        replay.save(tmp_path / "run.mp4")
    assert repr(replay) == "RvizReplay(2.00 s, 2 frames)"
