"""Plugins and their hooks: which there are, which are called, and in what order."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

import pytest

from simkit.plugins import Plugin, PluginEntry
from simkit.plugins import registry as registry_module
from simkit.plugins.plugin import HOOKS


@dataclass(frozen=True, slots=True, kw_only=True)
class Nothing:
    """No parameters."""


class Diary(Plugin[Nothing]):
    """Writes down which hook is called at which time [ms]."""

    Parameters = Nothing
    pages: ClassVar[list[tuple[str, str, float]]] = []

    def write(self, hook: str) -> None:
        self.pages.append((self.site.name, hook, self.site.now_ns / 1e6))

    def on_attach(self) -> None:
        self.write("on_attach")

    def before_step(self) -> None:
        self.write("before_step")

    def after_step(self) -> None:
        self.write("after_step")

    def on_reset(self) -> None:
        self.write("on_reset")

    def on_detach(self) -> None:
        self.write("on_detach")


class Idle(Plugin[Nothing]):
    """Does nothing."""

    Parameters = Nothing


@pytest.fixture
def robot(stage, link, monkeypatch):
    """Spawns a robot with two diaries, and a plugin that does nothing; gives it and the pages."""
    entries = tuple(
        PluginEntry(
            filename=f"lib{kind.__name__}.so",
            module="",
            class_name=kind.__name__,
            parameters=kind.Parameters,
        )
        for kind in (Diary, Idle)
    )
    monkeypatch.setattr(registry_module, "_ENTRIES", entries)
    monkeypatch.setattr(PluginEntry, "load", lambda self: globals()[self.class_name])
    monkeypatch.setattr(Diary, "pages", [])
    tags = "".join(
        f'<plugin name="{name}" filename="lib{kind}.so"/>'
        for name, kind in (("one", "Diary"), ("two", "Diary"), ("three", "Idle"))
    )
    return stage.spawn(f"{link()}<gazebo>{tags}</gazebo>"), Diary.pages


def test_hooks_are_called_in_the_order_of_the_tags_with_the_clock_at_both_ends_of_a_step(
    stage, robot
):
    _, pages = robot
    stage.run(0.002)
    assert pages == [
        ("one", "on_attach", 0.0),
        ("two", "on_attach", 0.0),
        *(
            (name, hook, time)
            for step in (0.0, 1.0)
            for hook, time in (("before_step", step), ("after_step", step + 1.0))
            for name in ("one", "two")
        ),
    ]


def test_a_reset_is_told_and_the_clock_goes_on(stage, robot):
    _, pages = robot
    stage.run(0.003)
    pages.clear()
    stage.gazebo.reset_world()
    stage.run(0.001)
    assert pages[:3] == [
        ("one", "on_reset", 3.0),
        ("two", "on_reset", 3.0),
        ("one", "before_step", 3.0),
    ]


def test_nothing_is_called_after_the_model_has_gone(stage, robot):
    _, pages = robot
    stage.gazebo.delete("r")
    stage.run(0.002)
    assert [hook for _, hook, _ in pages[2:]] == ["on_detach", "on_detach"]


def test_a_hook_that_is_not_overridden_is_not_called(stage, robot):
    spawned, _ = robot
    assert [type(one).__name__ for one in spawned.plugins] == ["Diary", "Diary", "Idle"]
    assert [hook for hook in HOOKS if Idle.overrides(hook)] == []
    assert [hook for hook in HOOKS if Diary.overrides(hook)] == list(HOOKS)
    hooks = stage.gazebo.world.before_step
    assert not any(getattr(hook, "__self__", None) is spawned.plugins[2] for hook in hooks)


@pytest.mark.parametrize("name", ["before_steps", "on_load", "after_update"])
def test_a_method_that_looks_like_a_hook_and_is_none_is_refused(name):
    methods: dict[str, Any] = {name: lambda self: None}
    with pytest.raises(TypeError, match=rf"Typo\.{name} is no hook; these are: on_attach, before"):
        type("Typo", (Plugin,), methods)


def test_a_plugin_says_nothing_of_what_is_missing_unless_it_says_who_speaks():
    site: Any = None
    assert Idle.speaker(site) is None
