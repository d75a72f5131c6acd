from __future__ import annotations

import gc
import html
import re
import weakref

import pytest

from simkit.graph.params import ParameterServer
from simkit.packages import PackagePath
from simkit.viz import LiveRviz, RvizSettings, SceneSource

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


def test_a_notebook_shows_the_page_as_it_is_now(live, turtles):
    turtles.put("world", "late", START)
    (source,) = re.findall(r'srcdoc="([^"]*)"', live._repr_html_())
    assert '"label":"late"' in html.unescape(source)


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
    server = view._server
    gone = weakref.ref(view)
    del view
    gc.collect()
    assert gone() is None
    assert not server.alive
