"""Which launch file a command line means."""

import pytest

from simkit.launch import LaunchError, find_launch_file, given_arguments

EMPTY = "<launch/>"


def test_a_file_is_found_by_its_name_anywhere_in_the_package(packages, write):
    path = write("deep/down/a.launch", EMPTY)
    assert find_launch_file(["play", "a.launch", "x:=1"], packages) == (path, ["x:=1"])
    assert find_launch_file(["play", "deep/down/a.launch"], packages) == (path, [])


def test_a_path_is_a_path(packages, write, monkeypatch):
    path = write("launch/a.launch", EMPTY)
    assert find_launch_file([str(path), "x:=1"], packages) == (path, ["x:=1"])
    monkeypatch.chdir(path.parent)
    found, rest = find_launch_file(["a.launch"], packages)
    assert (str(found), rest) == ("a.launch", [])


@pytest.mark.parametrize(
    ("words", "said", "remedy"),
    [
        (
            ["play", "b.launch"],
            "[b.launch] is neither a launch file in package [play] nor is [play] a launch file name",
            "Did you mean a.launch?",
        ),
        (
            ["plya", "a.launch"],
            "[a.launch] is neither a launch file in package [plya] nor is [plya] a launch file name",
            "Write the name of a package",
        ),
        (["nope.launch"], "[nope.launch] is not a launch file name", "PACKAGE FILE.launch"),
        (["play"], "[play] is not a launch file name", "simkit roslaunch play a.launch."),
        (["a.launch"], "[a.launch] is not a launch file name", "simkit roslaunch play a.launch."),
        (["nope.launch", "x:=1"], "[nope.launch] is not a launch file name", "PACKAGE FILE"),
        ([], "[] is not a launch file name", "PACKAGE FILE"),
    ],
)
def test_what_is_not_there_is_told_in_both_layers(packages, write, words, said, remedy):
    write("launch/a.launch", EMPTY)
    with pytest.raises(LaunchError) as caught:
        find_launch_file(words, packages)
    assert caught.value.said == f"RLException: {said}"
    assert remedy in caught.value.remedy
    assert caught.value.diagnostic.rule == "LCH-E01"


def test_a_package_with_a_slip_is_named(packages):
    with pytest.raises(LaunchError, match="did you mean 'play'"):
        find_launch_file(["plya", "a.launch"], packages)


def test_two_files_of_one_name_are_no_answer(packages, write):
    one, two = write("a/x.launch", EMPTY), write("b/x.launch", EMPTY)
    with pytest.raises(LaunchError) as caught:
        find_launch_file(["play", "x.launch"], packages)
    assert caught.value.said == (
        f"RLException: multiple files named [x.launch] in package [play]:\n- {one}\n- {two}\n"
        "Please specify full path instead"
    )


def test_arguments_are_names_with_values():
    assert given_arguments(["a:=1", "b:=", "c:=x:=y", "_p:=1", "__name:=n"]) == {
        "a": "1",
        "b": "",
        "c": "x:=y",
        "__name": "n",
    }


@pytest.mark.parametrize(
    ("words", "remedy"),
    [
        (["a"], "Write name:=value."),
        (["a=1"], "Write a:=1, with a colon."),
        (["a:=", "1"], "Write a:=1, without a blank."),
        (["-v"], "simkit roslaunch --help lists the options."),
        (["b.launch"], "Launch it in another terminal"),
    ],
)
def test_a_word_that_is_no_argument(words, remedy):
    with pytest.raises(LaunchError) as caught:
        given_arguments(words)
    assert caught.value.remedy.startswith(remedy)
    assert caught.value.diagnostic.rule == "LCH-E13"


def test_a_slip_in_a_path_is_named(packages, write):
    folder = write("launch/a.launch", EMPTY).parent
    with pytest.raises(LaunchError) as caught:
        find_launch_file([str(folder / "aa.launch")], packages)
    assert caught.value.remedy == "Did you mean a.launch, which is in that folder?"
