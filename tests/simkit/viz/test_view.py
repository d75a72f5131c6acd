from __future__ import annotations

import gc
import html
import json
import re
import weakref

import pytest

from simkit.errors import UnknownNameError
from simkit.graph.params import ParameterServer
from simkit.msgs import Time
from simkit.packages import PackagePath
from simkit.viz import LiveRviz, RvizSettings, RvizView, SceneSource
from simkit.viz.stage.parts import Role
from simkit.viz.stage.scene import Displays, make_scene
from simkit.viz.widgets.scene_widget import LEAST_PAUSE, SceneWidget


def view(buffer, fixed_frame="world", **options):
    return RvizView(make_scene(buffer, fixed_frame=fixed_frame, **options))


def test_the_page_has_a_picture_and_the_same_as_a_table(turtles, read_page):
    page = read_page(view(turtles).to_html())
    _, scene = page.by_id("scene")
    assert scene["tabindex"] == "0"
    assert scene["aria-label"].startswith("4 frames seen from world.")
    assert scene["aria-describedby"] == "numbers"
    assert page.by_id("numbers")[0] == "table"
    shown = [text.strip() for text in page.texts if text.strip()]
    place = shown.index("turtle2", shown.index("yaw [°]"))
    poses = ["3.625", "3.500", "0.000", *["0.0"] * 3]
    assert shown[place : place + 8] == ["turtle2", "world", *poses]


def test_before_any_script_runs_a_still_picture_is_there(arm_frames, arm, read_page):
    tag, still = read_page(view(arm_frames, robot=arm).to_html()).by_id("still")
    assert tag == "img"
    assert still["src"].startswith("data:image/png;base64,iVBOR")
    assert "hidden" not in still


def test_displays_have_a_checkbox_where_there_is_something_to_show(
    turtles, arm_frames, arm, read_page
):
    def boxes(shown):
        page = read_page(shown.to_html())
        labels = [attributes for tag, attributes in page.tags if tag in ("label", "input")]
        pairs = zip(labels[::2], labels[1::2], strict=True)
        return {box["id"]: "checked" in box for label, box in pairs if "hidden" not in label}

    assert boxes(view(turtles)) == {"grid": True, "tf": True, "names": True}
    both = {"grid": True, "tf": True, "names": True, "visual": True, "collision": False}
    assert boxes(view(arm_frames, robot=arm)) == both
    displays = Displays(grid=False, tf=False, robot=Role.COLLISION)
    assert boxes(view(arm_frames, robot=arm, displays=displays)) == {
        "grid": False,
        "tf": False,
        "names": True,
        "visual": False,
        "collision": True,
    }


def test_what_is_wrong_is_said(two_trees, read_page):
    shown = view(two_trees)
    assert len(shown.problems) == 4
    assert set(shown.problems) < set(read_page(shown.to_html()).texts)


def test_an_unknown_fixed_frame(turtles, read_page):
    shown = view(turtles, "wrold")
    page = read_page(shown.to_html())
    assert "does not exist" in shown.error
    assert shown.error in page.texts
    assert "hidden" not in page.by_id("error")[1]
    assert page.data["frames"] == []
    assert "hidden" in page.by_id("table")[1]


def test_nothing_received(buffer, read_page):
    shown = view(buffer)
    assert shown.error.startswith("No tf data.")
    assert shown.error in read_page(shown.to_html()).texts
    assert shown.to_png(scale=1).startswith(b"\x89PNG")


def test_another_time_is_another_view(turtles):
    early = view(turtles, time=Time(1_600_088_400))
    assert early.to_html() != view(turtles).to_html()


def test_hostile_names_are_only_names(hostile, read_page):
    shown = view(hostile, "wörld")
    page = read_page(shown.to_html())
    assert len(page.scripts) == 2
    assert "<script>alert(1)</script>" in page.texts
    assert shown.to_png(scale=1).startswith(b"\x89PNG")
    bad = view(hostile, "</script><script>alert(2)</script>")
    assert len(read_page(bad.to_html()).scripts) == 2
    bad.to_html().encode("utf-8")


def test_equal_scenes_give_equal_bytes_and_later_frames_change_nothing(arm_frames, arm):
    one, two = view(arm_frames, robot=arm), view(arm_frames, robot=arm)
    before = one.to_html(), one.to_png(scale=1)
    assert (two.to_html(), two.to_png(scale=1)) == before
    arm_frames.put("world", "late")
    assert one.to_html() == before[0]


def test_notebooks_show_it_in_a_frame_of_its_own(two_trees):
    shown = view(two_trees)
    cell = shown._repr_html_()
    (source,) = re.findall(r'srcdoc="([^"]*)"', cell)
    assert html.unescape(source) == shown.to_html()
    assert 'sandbox="allow-scripts"' in cell
    assert repr(shown) == "RvizView('4 frames seen from world.')"


def test_a_view_is_a_few_hundred_kilobytes(arm_frames, arm):
    assert len(view(arm_frames, robot=arm)._repr_html_()) < 400_000


def test_save_writes_by_suffix(turtles, tmp_path):
    shown = view(turtles)
    for suffix in (".html", ".png"):
        shown.save(tmp_path / f"tf{suffix}")
    assert (tmp_path / "tf.html").read_text(encoding="utf-8") == shown.to_html()
    assert (tmp_path / "tf.png").read_bytes().startswith(b"\x89PNG")
    with pytest.raises(UnknownNameError, match=r"no picture format '\.gif'"):
        shown.save(str(tmp_path / "tf.gif"))


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
