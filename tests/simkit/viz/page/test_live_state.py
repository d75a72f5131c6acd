from __future__ import annotations

import json
from dataclasses import replace

import pytest

from simkit.graph.params import ParameterServer
from simkit.packages import PackagePath
from simkit.viz import RvizSettings, SceneSource
from simkit.viz.page.live_state import LiveNews
from simkit.viz.stage.marks import Marks

START = 1_600_088_400
ROBOT = '<robot name="r"><link name="a"/></robot>'


@pytest.fixture
def parameters():
    return ParameterServer()


@pytest.fixture
def news(turtles, parameters):
    source = SceneSource(
        RvizSettings(), buffer=turtles, parameters=parameters, packages=PackagePath([])
    )
    return LiveNews(source)


def told(state, known=None):
    text = state.news(known)
    return None if text is None else json.loads(text)


def test_somebody_new_is_told_everything(news):
    found = told(news.look())
    assert [frame["label"] for frame in found["scene"]["frames"]] == [
        *("world", "turtle1", "carrot1", "turtle2")
    ]
    assert set(found["news"]["poses"]) == {"0", "1", "2", "3"}


def test_who_knows_everything_is_told_nothing(news):
    state = news.look()
    assert told(state, state) is None


def test_only_what_has_moved_is_told(news, turtles):
    before = news.look()
    turtles.put("world", "turtle2", START + 5, (4, 4, 0))
    after = news.look()
    found = told(after, before)
    assert found == {"news": {"poses": {"3": [4, 4, 0, 0, 0, 0, 1]}}}
    assert after.scene == before.scene


def test_points_and_lines_are_told_when_they_are_others(news):
    contact = Marks(name="contacts", label="Contacts", color="#00ff00", points=((1.0, 2.0, 3.0),))
    state = replace(news.look(), marks=(contact,))
    data = [{"points": [1, 2, 3], "lines": []}]
    assert told(state, news.look()) == {"news": {"marks": data}}
    assert told(state, state) is None
    # Who gets another scene is told them anew.
    assert told(state, replace(state, number=-1))["news"]["marks"] == data


@pytest.mark.parametrize("change", ["a frame", "the robot", "beyond the grid", "another parent"])
def test_what_is_new_makes_another_scene(news, turtles, parameters, change):
    before = news.look()
    match change:
        case "a frame":
            turtles.put("world", "late", START)
        case "the robot":
            parameters.set("/robot_description", ROBOT)
        case "beyond the grid":
            turtles.put("world", "turtle2", START + 5, (40, 4, 0))
        case "another parent":
            turtles.put("turtle1", "turtle2", START + 5)
    after = news.look()
    assert after.number == before.number + 1
    assert "scene" in told(after, before)
    assert news.look().number == after.number


def test_without_frames_there_is_a_scene_all_the_same(buffer, parameters):
    source = SceneSource(
        RvizSettings(), buffer=buffer, parameters=parameters, packages=PackagePath([])
    )
    found = told(LiveNews(source).look())
    assert found["scene"]["error"].startswith("No tf data.")
    assert found["news"] == {}
