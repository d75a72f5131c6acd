"""The page of turtlesim, for terminals."""

from __future__ import annotations

import json
import urllib.request

import pytest

from simkit import Simulation
from simkit.viz.turtlesim.page import LiveTurtlesim, TurtlesimState


@pytest.fixture
def watched(frame):
    """A page of a window with a turtle, what its viewers were told, and a clock that the test sets."""
    now = [0.0]
    page = LiveTurtlesim(frame, clock=lambda: now[0])
    yield page, now
    page.close()


def test_a_viewer_is_told_only_what_it_does_not_know():
    state = TurtlesimState(svg="<svg/>")
    assert json.loads(state.news(None)) == {"svg": "<svg/>"}
    assert state.news(TurtlesimState(svg="<svg/>")) is None
    assert state.news(TurtlesimState(svg="")) is not None


def test_nothing_is_drawn_while_nobody_looks_and_not_too_often(watched, monkeypatch):
    page, now = watched
    told = []
    monkeypatch.setattr(page._server, "update", told.append)
    page.refresh()
    assert told == []
    monkeypatch.setattr(page._server, "_viewers", {object()})
    page.refresh()
    page.refresh()
    assert len(told) == 1
    now[0] = 0.06
    page.refresh()
    assert len(told) == 2
    monkeypatch.undo()


def test_the_page_may_talk_to_its_own_server_only(watched):
    page, _ = watched
    with urllib.request.urlopen(page.url) as answer:
        text = answer.read().decode()
    assert f"connect-src {page._server.socket_url}" in text
    page.close()
    assert not page.alive


def test_a_turtlesim_in_a_terminal_says_where_its_window_is(capsys):
    with Simulation() as sim:
        node = sim.rosrun("turtlesim", "turtlesim_node")
        page = sim.serve_window_of(node)
        assert f"turtlesim is at {page.url} " in capsys.readouterr().out
        assert "turtle1" in page._state().svg
        node.shutdown()
        sim.run(0.1)
        assert not page.alive
