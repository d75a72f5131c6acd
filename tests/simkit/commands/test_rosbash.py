"""roscd, rosls, rosed."""

import pytest


@pytest.fixture(autouse=True)
def in_a_workspace(package, monkeypatch):
    for name in ("urdf/arm.urdf", "old/arm.urdf", "launch/begin.launch"):
        file = package.folder / "play" / name
        file.parent.mkdir(exist_ok=True)
        file.write_text("<launch/>")
    monkeypatch.chdir(package.folder)
    monkeypatch.setenv("EDITOR", "cat")


def test_roscd_names_the_folder(simkit, package):
    assert simkit("roscd", "play/urdf") == (0, f"{package.folder / 'play' / 'urdf'}\n", "")
    assert simkit("roscd") == (0, f"{package.folder}\n", "")


def test_rosls_lists_a_folder(simkit):
    assert simkit("rosls", "play/launch") == (0, "begin.launch\n", "")


def test_rosed_hands_the_file_to_the_editor(simkit):
    assert simkit("rosed", "play", "begin.launch") == (0, "<launch/>", "")


@pytest.mark.parametrize(
    ("words", "text"),
    [
        (("roscd", "play/urfd"), "did you mean 'urdf'"),
        (("rosls", "paly"), "did you mean 'play'"),
        (("rosls", "turtlesim"), "comes with simkit"),
        (("rosed", "play", "begin.lanch"), "did you mean 'begin.launch'"),
        (("rosed", "play", "arm.urdf"), "old/arm.urdf, urdf/arm.urdf"),
    ],
)
def test_what_is_not_there_is_explained(simkit, words, text):
    code, out, err = simkit(*words)
    assert (code, out) == (1, "")
    assert text in err
    assert err.count("\n") == 1


def test_without_an_editor_the_sentence_says_how_to_name_one(simkit, monkeypatch):
    monkeypatch.delenv("EDITOR")
    monkeypatch.setenv("PATH", "")
    assert "export EDITOR=nano" in simkit("rosed", "play", "begin.launch")[2]
