"""check_urdf: what ROS prints on standard output, what we find on standard error."""

from __future__ import annotations

import io
import json
import os
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest

from simkit.commands.rule_book import rule_book

CLEAN = """<?xml version="1.0"?>
<robot name="arm">
  <link name="world"/>
  <link name="b"/>
  <link name="a"/>
  <joint name="j" type="fixed">
    <parent link="world"/>
    <child link="b"/>
  </joint>
  <joint name="i" type="continuous">
    <parent link="world"/>
    <child link="a"/>
    <axis xyz="0 0 1"/>
  </joint>
</robot>
"""
TREE = """robot name is: arm
---------- Successfully Parsed XML ---------------
root Link: world has 2 child(ren)
    child(1):  a
    child(2):  b
"""
REFUSED = CLEAN.replace('child link="b"', 'child link="B"')
DOUBTFUL = CLEAN.replace('    <axis xyz="0 0 1"/>\n', "")


@pytest.fixture(autouse=True)
def in_a_workspace(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("SIMKIT_PACKAGE_PATH", raising=False)
    folder = tmp_path / "hello_ros" / "urdf"
    folder.mkdir(parents=True)
    (tmp_path / "hello_ros" / "package.xml").write_text("<package/>")
    for name, text in (("clean", CLEAN), ("refused", REFUSED), ("doubtful", DOUBTFUL)):
        (folder / f"{name}.urdf").write_text(text)


# -- what ROS says


def test_a_good_file_gives_the_tree_and_silence(simkit):
    code, out, err = simkit("check_urdf", "hello_ros/urdf/clean.urdf")
    assert (code, out) == (0, TREE)
    assert err == ""


def test_a_refused_file_gives_255_and_what_is_wrong(simkit):
    code, out, err = simkit("check_urdf", "hello_ros/urdf/refused.urdf")
    assert (code, out) == (255, "")
    lines = err.splitlines()
    assert lines[0] == "Error:   Failed to build tree: child link [B] of joint [j] not found"
    assert "ERROR: Model Parsing the xml failed" in lines
    assert "hello_ros/urdf/refused.urdf:8:18: error [URDF-E02] " in err
    assert '    8 |     <child link="B"/>\n      |                  ^\n' in err
    assert "remedy: Did you mean 'b'? Write link=\"b\"." in err
    assert err.rstrip().endswith(("1 error", "--notes tells more)"))


def test_without_a_file(simkit):
    code, out, err = simkit("check_urdf")
    assert (code, out, err) == (255, "", "simkit check_urdf: Expect URDF xml file to parse\n")


# -- severity and exit code


def test_warnings_leave_the_exit_code_alone_unless_strict(simkit):
    assert simkit("check_urdf", "hello_ros/urdf/doubtful.urdf")[0] == 0
    code, out, err = simkit("check_urdf", "--strict", "hello_ros/urdf/doubtful.urdf")
    assert code == 1
    assert out == TREE
    assert "warning [URDF-W09]" in err
    assert simkit("check_urdf", "--strict", "hello_ros/urdf/clean.urdf")[0] == 0
    assert simkit("check_urdf", "--strict", "hello_ros/urdf/refused.urdf")[0] == 255


def test_notes_are_short_unless_asked_for(simkit):
    Path("noted.urdf").write_text(CLEAN.replace("0 0 1", "0 0 2"))
    _, _, brief = simkit("check_urdf", "noted.urdf")
    _, _, whole = simkit("check_urdf", "--notes", "noted.urdf")
    assert "note [" in brief
    assert "remedy:" not in brief
    assert "(--notes tells more)" in brief
    assert "remedy:" in whole


# -- several files, standard input


def test_several_files_have_headings_and_the_worst_code(simkit):
    names = [f"hello_ros/urdf/{name}.urdf" for name in ("clean", "refused", "doubtful")]
    code, out, err = simkit("check_urdf", *names)
    assert code == 255
    assert out == f"== {names[0]}\n{TREE}== {names[1]}\n== {names[2]}\n{TREE}"
    assert err.index(f"== {names[1]}\n") < err.index("URDF-E02") < err.index(f"== {names[2]}\n")


def test_standard_input(simkit, monkeypatch):
    monkeypatch.setattr("sys.stdin", SimpleNamespace(buffer=io.BytesIO(REFUSED.encode())))
    code, _, err = simkit("check_urdf", "-")
    assert code == 255
    assert "<stdin>:8:18: error" in err


# -- which file is meant


def test_a_file_of_a_package(simkit):
    code, out, _ = simkit("check_urdf", "package://hello_ros/urdf/clean.urdf")
    assert (code, out) == (0, TREE)
    _, _, err = simkit("check_urdf", "package://hello_ros/urdf/refused.urdf")
    assert f"{Path('hello_ros/urdf/refused.urdf')}:8:18: " in err


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("clean.urdf", str(Path("hello_ros/urdf/clean.urdf"))),
        ("hello_ros/urdf/claen.urdf", "did you mean clean.urdf?"),
        ("package://helo_ros/urdf/clean.urdf", "did you mean 'hello_ros'?"),
        ("package://hello_ros/urdf/claen.urdf", "did you mean clean.urdf?"),
        ("package://hello_ros", "has no file ''"),
        ("hello_ros/urdf", "is a folder, not a file; in it are clean.urdf, doubtful.urdf"),
        ("n" * 5000, "no file"),
        ("no\0file", "no file"),
        ("", "no file ''"),
    ],
)
def test_a_file_that_is_not_there_is_one_line(simkit, name, text):
    code, out, err = simkit("check_urdf", name)
    assert (code, out) == (255, "")
    assert text in err
    assert err.startswith("simkit check_urdf: ")
    assert err.count("\n") == 1


def test_what_is_no_text_is_said_so(simkit, tmp_path):
    (tmp_path / "a.urdf").write_bytes(b"\x7fELF\0\0\0")
    assert "is no text" in simkit("check_urdf", "a.urdf")[2]
    (tmp_path / "b.urdf").write_bytes(b" " * 20_000_001)
    assert "more than 20 MB" in simkit("check_urdf", "b.urdf")[2]


@pytest.mark.skipif(
    os.name != "posix" or os.geteuid() == 0,
    reason="only a user who is not root can be refused a file",
)
def test_a_file_that_may_not_be_read(simkit, tmp_path):
    path = tmp_path / "a.urdf"
    path.write_text(CLEAN)
    path.chmod(0)
    code, _, err = simkit("check_urdf", "a.urdf")
    assert code == 255
    assert "cannot be read" in err


def test_an_empty_file_is_what_ros_says(simkit, tmp_path):
    (tmp_path / "a.urdf").write_text("")
    code, out, err = simkit("check_urdf", "a.urdf")
    assert (code, out) == (255, "")
    assert err.startswith("Error:   Error document empty.")
    assert "URDF-E01" in err


# -- companions


def test_files_beside_it_are_checked_with_it(simkit, tmp_path):
    (tmp_path / "a.launch").write_text("<launch>\n  <param name='x' value='1'>\n</launch>\n")
    code, out, err = simkit("check_urdf", "hello_ros/urdf/clean.urdf", "a.launch")
    assert (code, out) == (0, TREE)
    assert "a.launch:2:" in err
    assert simkit("check_urdf", "hello_ros/urdf/clean.urdf", "--launch", "a.launch")[2] == err
    code, _, err = simkit("check_urdf", "hello_ros/urdf/clean.urdf", "--yaml", "nix.yaml")
    assert code == 255
    assert "no file 'nix.yaml'" in err


def test_a_companion_alone_is_no_robot(simkit):
    code, out, err = simkit("check_urdf", "a.launch")
    assert (code, out) == (255, "")
    assert err.startswith("simkit check_urdf: Expect URDF xml file to parse; a.launch is checked ")


# -- JSON


def test_json_is_all_that_stands_on_standard_output(simkit):
    names = [f"hello_ros/urdf/{name}.urdf" for name in ("refused", "doubtful")]
    code, out, err = simkit("check_urdf", "--format", "json", *names)
    assert (code, err) == (255, "")
    found = json.loads(out)
    assert found["summary"]["errors"] == 1
    (error,) = [one for one in found["diagnostics"] if one["severity"] == "error"]
    assert (error["rule"], error["line"], error["column"]) == ("URDF-E02", 8, 18)
    assert {one["file"] for one in found["diagnostics"]} == set(names)


# -- the rules


def test_the_rules_are_listed(simkit):
    code, out, err = simkit("check_urdf", "--list-rules")
    assert (code, err) == (0, "")
    assert len(out.splitlines()) == len(rule_book())
    assert out.splitlines()[0].split() == ["URDF-E01", "error", "not", "well-formed", "XML"]


def test_a_rule_is_explained(simkit):
    code, out, _ = simkit("check_urdf", "--explain", "urdf-w07")
    assert code == 0
    assert out.startswith("URDF-W07 (warning): degrees where radians are meant\n\n")
    assert "1.5708" in out
    assert "GZ-" not in out
    assert simkit("check_urdf", "--explain", "E05")[1].startswith("URDF-E05 ")


def test_an_unknown_rule_names_near_ones(simkit):
    code, out, err = simkit("check_urdf", "--explain", "URDF-W7")
    assert (code, out) == (2, "")
    assert "URDF-W07" in err
    assert "--list-rules" in simkit("check_urdf", "--explain", "?")[2]


# -- a terminal


def test_colours_are_for_terminals_only(simkit, monkeypatch):
    name = "hello_ros/urdf/refused.urdf"
    assert "\x1b" not in simkit("check_urdf", name)[2]
    monkeypatch.delenv("NO_COLOR", raising=False)
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True, raising=False)
    assert "\x1b[" in simkit("check_urdf", name)[2]
    monkeypatch.setenv("NO_COLOR", "1")
    assert "\x1b" not in simkit("check_urdf", name)[2]


def modules_loaded_for(name):
    program = (
        "import sys; from simkit.cli import main; "
        f"main(['check_urdf', 'hello_ros/urdf/{name}.urdf']); print(*sys.modules)"
    )
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True
    )
    return set(done.stdout.split())


def test_it_starts_without_what_costs_a_few_milliseconds_each():
    needless = {"shutil", "json", "difflib", "yaml"}
    assert needless & modules_loaded_for("clean") == set()


def test_it_starts_without_anything_heavy():
    heavy = {"numpy", "lxml", "matplotlib", "yaml", "rosbags", "asyncio", "simkit.simulation"}
    assert heavy & modules_loaded_for("refused") == set()
