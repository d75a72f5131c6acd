"""The engine is loaded late, and its absence is said in one sentence."""

from __future__ import annotations

import subprocess
import sys

import pytest

from simkit.physics import NoEngineError, World
from simkit.physics import engine as engine_module


def test_without_dartpy_one_sentence_says_what_to_do(monkeypatch):
    engine_module.dart.cache_clear()
    monkeypatch.setitem(sys.modules, "dartpy", None)
    with pytest.raises(NoEngineError) as caught:
        World()
    engine_module.dart.cache_clear()
    text = str(caught.value)
    assert "pip install dartpy" in text
    for platform in (
        "Linux with Python 3.10 to 3.14",
        "Windows",
        "macOS 15 or newer on Apple silicon",
    ):
        assert platform in text
    assert "\n" not in text


def test_physics_is_imported_without_dartpy_and_without_trimesh():
    program = "import sys, simkit.physics; print('dartpy' in sys.modules, 'trimesh' in sys.modules)"
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True
    )
    assert done.stdout.split() == ["False", "False"]


def test_nothing_sleeps(new_world):
    world = new_world()
    assert not world._engine.getDeactivationOptions().mEnabled
