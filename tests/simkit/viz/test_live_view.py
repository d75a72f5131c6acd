from __future__ import annotations

from types import SimpleNamespace

import pytest

from simkit.viz import LiveView, TurtleReplay, TurtlesimView, live_view


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
    monkeypatch.setattr(live_view, "running_notebook", lambda: notebook)
    monkeypatch.setattr(live_view, "_new_handle", lambda: notebook)
    return notebook


@pytest.fixture
def scene():
    """A picture that can be changed, a clock that can be set, and a view of both."""
    scene = SimpleNamespace(svg="<svg>0</svg>", now=0.0)
    picture = SimpleNamespace(_repr_svg_=lambda: scene.svg)
    scene.view = LiveView(lambda: picture, clock=lambda: scene.now)
    return scene


def test_outside_a_notebook_it_does_nothing(scene):
    assert live_view.running_notebook() is None
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
