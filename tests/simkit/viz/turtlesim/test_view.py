"""The window of turtlesim that follows it, in notebooks and for terminals."""

from __future__ import annotations

import json
import urllib.request
from types import SimpleNamespace

import pytest

from simkit import Simulation
from simkit.viz import LiveView, TurtleReplay, TurtlesimView
from simkit.viz.turtlesim import view as turtlesim_view
from simkit.viz.turtlesim.view import LiveTurtlesim, TurtlesimState


class Notebook:
    """A notebook's kernel, as far as a live view talks to it."""

    def __init__(self):
        self.sent = []
        self.callbacks = []
        self.events = SimpleNamespace(
            register=lambda name, call: self.callbacks.append((name, call))
        )

    def display(self, bundle, *, raw):
        self.sent.append(("display", bundle["image/svg+xml"]))

    def update(self, bundle, *, raw):
        self.sent.append(("update", bundle["image/svg+xml"]))


@pytest.fixture
def notebook(monkeypatch):
    notebook = Notebook()
    monkeypatch.setattr(turtlesim_view, "running_notebook", lambda: notebook)
    monkeypatch.setattr(turtlesim_view, "_new_handle", lambda: notebook)
    return notebook


@pytest.fixture
def scene():
    """A picture that can be changed, a clock that can be set, and a view of both."""
    scene = SimpleNamespace(svg="<svg>0</svg>", now=0.0)
    picture = SimpleNamespace(_repr_svg_=lambda: scene.svg)
    scene.view = LiveView(lambda: picture, clock=lambda: scene.now)
    return scene


def test_outside_a_notebook_it_does_nothing(scene):
    assert turtlesim_view.running_notebook() is None
    scene.view.refresh()
    with pytest.raises(NotImplementedError):
        scene.view._ipython_display_()
    scene.view.close()
    assert repr(scene.view) == "LiveView(seen in a notebook only)"


def test_it_is_shown_once_and_then_updated(scene, notebook):
    scene.view.refresh()
    assert notebook.sent == []
    scene.view._ipython_display_()
    for number in (1, 2):
        scene.now += 1.0
        scene.svg = f"<svg>{number}</svg>"
        scene.view.refresh()
    assert notebook.sent == [
        ("display", "<svg>0</svg>"),
        ("update", "<svg>1</svg>"),
        ("update", "<svg>2</svg>"),
    ]


def test_an_unchanged_picture_is_not_sent_again(scene, notebook):
    scene.view._ipython_display_()
    scene.now += 1.0
    scene.view.refresh()
    assert len(notebook.sent) == 1


def test_updates_are_paced_but_the_last_one_is_never_lost(scene, notebook):
    scene.view._ipython_display_()
    for number in range(100):
        scene.now += 0.001
        scene.svg = f"<svg>{number}</svg>"
        scene.view.refresh()
    assert len(notebook.sent) < 5
    ((event, call),) = notebook.callbacks
    assert event == "post_run_cell"
    call(object())
    assert notebook.sent[-1] == ("update", "<svg>99</svg>")


def test_a_closed_view_is_left_as_it_is(scene, notebook):
    scene.view._ipython_display_()
    scene.view.close()
    scene.svg, scene.now = "<svg>1</svg>", 9.0
    scene.view.refresh()
    notebook.callbacks[0][1]()
    assert len(notebook.sent) == 1


def test_turtlesim_can_be_watched_and_replayed(window, notebook):
    views = []
    turtlesim = TurtlesimView(window.node, add_view=views.append)
    assert turtlesim.frame is window.frame
    assert "turtle1" in turtlesim.picture(names=True).to_svg()
    turtlesim.live()._ipython_display_()
    window.drive(1.0)
    window.run(1.0)
    (refresh,) = views
    refresh()
    (_, before), (_, after) = notebook.sent
    assert after != before
    assert after == turtlesim.picture(names=True).to_svg()
    assert isinstance(turtlesim.replay(), TurtleReplay)
    assert turtlesim.replay().tape.duration > 0.9


@pytest.fixture
def watched(frame):
    """A page of a window with a turtle, what its viewers were told, and a clock that the test sets."""
    now = [0.0]
    page = LiveTurtlesim(frame, clock=lambda: now[0])
    yield page, now
    page.close()


def test_a_viewer_is_told_only_what_it_does_not_know():
    state = TurtlesimState(svg="<svg/>")
    assert json.loads(state.changes(None)) == {"svg": "<svg/>"}
    assert state.changes(TurtlesimState(svg="<svg/>")) is None
    assert state.changes(TurtlesimState(svg="")) is not None


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
