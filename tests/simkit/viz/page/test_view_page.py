from __future__ import annotations

import base64
import importlib.util
import subprocess
import sys
import zlib

import pytest

from simkit.errors import SimkitError
from simkit.viz.page.view_page import packed_library


def test_it_is_the_viewer_of_meshcat_in_a_third_of_its_length():
    packed = packed_library()
    script = zlib.decompress(base64.b64decode(packed)).decode("utf-8")
    assert "MeshCat" in script
    assert "InstancedMesh" in script
    assert len(packed) < 0.4 * len(script)


def test_meshcat_itself_is_not_imported():
    program = (
        "import sys; from simkit.viz.page.view_page import packed_library; packed_library();"
        "print(sorted({'meshcat', 'zmq', 'tornado', 'IPython'} & set(sys.modules)))"
    )
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True
    )
    assert done.stdout.strip() == "[]"


def test_without_meshcat_a_sentence_says_what_to_do(monkeypatch):
    packed_library.cache_clear()
    monkeypatch.setattr(importlib.util, "find_spec", lambda _: None)
    with pytest.raises(SimkitError, match="pip install meshcat"):
        packed_library()
