import sys
from pathlib import Path

import grader
import simkit
from grader.sandbox.bubblewrap import bubblewrap_prefix
from grader.sandbox.mounts import Mounts, node_mounts

PACKAGE = Path("/tmp/run/work")


def test_a_node_sees_python_simkit_and_its_package():
    shown = node_mounts(PACKAGE).shown
    assert Path(sys.prefix) in shown
    assert Path(sys.base_prefix) in shown
    assert Path(simkit.__file__).parent in shown
    assert PACKAGE in shown


def test_a_node_does_not_see_the_workbook():
    root = Path(simkit.__file__).parent.parent
    mounts = node_mounts(PACKAGE, private=[root])
    for secret in ("exercises", "solutions", "tests", "grader", ".git"):
        path = root / secret
        visible = False
        for step, is_shown in mounts.in_order():
            if path.is_relative_to(step):
                visible = is_shown
        assert not visible, secret


def test_a_workbook_inside_of_the_system_is_hidden_but_not_its_python():
    mounts = Mounts(
        shown=(Path("/usr"), Path("/usr/src/course/.venv"), Path("/usr/src/course/simkit")),
        hidden=(Path("/usr/src/course"),),
    )
    assert [str(path) for path, _ in mounts.in_order()] == [
        "/usr",
        "/usr/src/course",
        "/usr/src/course/.venv",
        "/usr/src/course/simkit",
    ]


def test_what_is_private_is_hidden_only_where_it_would_be_seen(tmp_path):
    assert tmp_path not in node_mounts(PACKAGE, private=[tmp_path]).hidden
    inside = Path(sys.prefix) / "submissions"
    assert inside in node_mounts(PACKAGE, private=[inside]).hidden


def test_an_environment_in_the_workbooks_own_folder_is_not_hidden_as_a_whole(monkeypatch, tmp_path):
    (tmp_path / "solutions").mkdir()
    (tmp_path / "lib").mkdir()
    monkeypatch.setattr(sys, "prefix", str(tmp_path))
    mounts = node_mounts(PACKAGE, private=[tmp_path])
    assert tmp_path in mounts.shown
    assert tmp_path not in mounts.hidden
    assert tmp_path / "solutions" in mounts.hidden


def test_an_installed_grader_is_hidden(monkeypatch):
    home = Path(grader.__file__).parent
    monkeypatch.setattr(sys, "path", [*sys.path, str(home.parent / "x-packages")])
    monkeypatch.setattr(sys, "prefix", str(home.parent))
    assert home in node_mounts(PACKAGE).hidden


def test_the_command_line_is_the_same_each_time():
    mounts = node_mounts(PACKAGE)
    for as_root in (True, False):
        first = bubblewrap_prefix(mounts, as_root=as_root)
        assert first == bubblewrap_prefix(mounts, as_root=as_root)
        assert "--die-with-parent" in first
        assert "--new-session" in first
