from __future__ import annotations

import gc
import json
import re
import weakref

import pytest

from simkit.graph.params import ParameterServer
from simkit.packages import PackagePath
from simkit.viz import LiveRviz, RvizSettings, SceneSource
from simkit.viz.widgets.scene_widget import LEAST_PAUSE, SceneWidget

START = 1_600_088_400


@pytest.fixture
def source(turtles):
    return SceneSource(
        RvizSettings(), buffer=turtles, parameters=ParameterServer(), packages=PackagePath([])
    )


@pytest.fixture
def live(source):
    view = LiveRviz(source)
    yield view
    view.close()


def test_the_page_may_talk_to_its_server_and_to_nobody_else(live, read_page):
    page = read_page(live.to_html())
    (policy,) = [a["content"] for tag, a in page.tags if "http-equiv" in a]
    address = live.url.replace("http:", "ws:") + "socket"
    assert policy.endswith(f"; connect-src {address}")
    assert page.data["socket"] == address
    assert page.by_id("live")[1]["role"] == "status"


def test_the_widget_of_a_notebook_opens_no_port(source, turtles, read_page):
    live = LiveRviz(source)
    page = read_page(live.widget.page)
    assert page.data["socket"] == ""
    (policy,) = [a["content"] for tag, a in page.tags if "http-equiv" in a]
    assert "connect-src" not in policy
    assert live._server is None
    live.refresh(now=True)
    assert live.widget.scene == ""
    turtles.put("world", "late", START)
    live.refresh(now=True)
    assert '"label":"late"' in live.widget.scene
    assert json.loads(live.widget.moment)["number"] == json.loads(live.widget.scene)["number"] == 1
    live.close()
    assert "over" in live.widget.status
    assert live._server is None


def test_a_widget_is_not_told_more_often_than_a_notebook_can_take(source, turtles):
    now = [0.0]
    widget = SceneWidget(source, clock=lambda: now[0])
    moments = []
    for step in range(10):
        turtles.put("world", "turtle1", START + step, (step, 0, 0))
        now[0] += LEAST_PAUSE / 2
        widget.refresh()
        moments.append(widget.moment)
    assert 4 <= len(set(moments)) <= 6


def test_it_tells_its_address(live):
    assert repr(live) == f"LiveRviz({live.url})"
    assert re.fullmatch(r"http://127\.0\.0\.1:\d+/[\w-]{20,}/", live.url)
    live.close()
    assert repr(live) == "LiveRviz(ended)"


def test_after_its_end_a_look_does_nothing(live):
    live.close()
    live.refresh()
    live.close()
    assert not live.alive


def test_it_ends_when_that_which_it_belongs_to_is_over(source):
    over = []
    view = LiveRviz(source, is_over=lambda: bool(over))
    view.refresh()
    assert view.alive
    over.append(True)
    view.refresh()
    assert not view.alive


def test_one_that_nobody_has_any_more_ends(source):
    view = LiveRviz(source)
    assert view.url
    server = view._server
    gone = weakref.ref(view)
    del view
    gc.collect()
    assert gone() is None
    assert not server.alive
