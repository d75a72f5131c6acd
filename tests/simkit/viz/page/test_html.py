from __future__ import annotations

import html
import re
from importlib import resources

import pytest

from simkit.viz.page.html import html_page, inline_frame

NASTY = "</script><script>alert(1)</script><!-- & \u2028 \x00 \ud800"


def page(data=None, **changes):
    options = {"title": "t", "name": "turtle_replay", "body": "<p>b</p>", "data": data} | changes
    return html_page(**options)


def test_data_survive_and_cannot_end_their_element(read_page):
    text = page({"name": NASTY, "values": [1.5, None]})
    found = read_page(text)
    assert found.data == {"name": NASTY, "values": [1.5, None]}
    assert len(found.scripts) == 2
    text.encode("utf-8")


def test_the_title_is_text(read_page):
    assert "<b>&" in read_page(page(title="<b>&")).texts


def test_numbers_that_json_lacks_are_refused():
    with pytest.raises(ValueError, match="JSON"):
        page(float("nan"))


def test_a_page_inside_another_keeps_every_letter():
    text = page({"name": NASTY.replace("\ud800", "")})
    frame = inline_frame(text, title='a "title"', height=300)
    assert frame.count("<iframe") == frame.count("<script>") == frame.count("</script>") == 1
    (source,) = re.findall(r'srcdoc="([^"]*)"', frame)
    assert html.unescape(source) == text
    assert 'sandbox="allow-scripts"' in frame
    assert 'height="300"' in frame
    assert "&quot;title&quot;" in frame


def test_our_scripts_are_small_and_ask_nobody():
    assets = resources.files("simkit.viz.page").joinpath("assets")
    scripts = [file for file in assets.iterdir() if file.name.endswith(".js")]
    assert len(scripts) > 5
    for script in scripts:
        text = script.read_text(encoding="utf-8")
        assert len(text) < 10_000
        assert not re.search(r"fetch|XMLHttp|import\b|innerHTML|eval|Function\(", text)
        assert ("WebSocket" in text) == (script.name == "live.js")


def test_a_page_talks_to_nobody_unless_it_is_allowed(read_page):
    def policy(text):
        (found,) = [a["content"] for tag, a in read_page(text).tags if "http-equiv" in a]
        return found

    assert "connect-src" not in policy(page())
    assert policy(page(connects_to="ws://127.0.0.1:1/x")).endswith("connect-src ws://127.0.0.1:1/x")


def test_several_scripts_are_one():
    text = page(scripts=["tape", "turtle_replay"])
    assert text.count("<script>") == 1
    assert 0 < text.index("class Player") < text.index("new Player")
