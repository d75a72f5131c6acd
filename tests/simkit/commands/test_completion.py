"""What Tab offers."""

import pytest

from simkit.commands import completion
from simkit.commands.completion import completions
from simkit.commands.table import COMMANDS


@pytest.fixture(autouse=True)
def in_a_workspace(package, monkeypatch):
    for name in ("launch/begin.launch", "talker.py"):
        file = package.folder / "play" / name
        file.parent.mkdir(exist_ok=True)
        file.write_text("<launch/>")
    monkeypatch.chdir(package.folder)


@pytest.mark.parametrize(
    ("line", "offered"),
    [
        ("simkit rosr", ["rosrun"]),
        ("rosrun turt", ["turtlesim"]),
        ("simkit rosrun pl", ["play"]),
        ("rosrun play ta", ["talker.py"]),
        ("rosrun turtlesim turtle_", ["turtle_teleop_key"]),
        ("rosrun turtlesim mimic ", []),
        ("roslaunch play ", ["begin.launch"]),
        ("roscd pl", ["play"]),
        ("rosmsg show geometry_msgs/Pos", ["Pose", "Pose2D", "PoseArray", "PoseStamped"]),
        ("rossrv md5 std_srvs/E", ["std_srvs/Empty"]),
        ("rostopic e", ["echo"]),
        ("rosparam g", ["get"]),
        ("nothing at", []),
        ("rosrun unknown ", []),
    ],
)
def test_what_may_follow(line, offered):
    found = completions(line.split(" "))
    assert found[: len(offered)] == [
        f"geometry_msgs/{one}" if one.startswith("Pose") else one for one in offered
    ]
    assert bool(found) == bool(offered)


@pytest.mark.parametrize("words", [["rostopic", "echo", ""], ["rosnode", "info", ""]])
def test_without_a_simulation_nothing_of_it_is_offered(words, monkeypatch, tmp_path):
    monkeypatch.setenv("SIMKIT_SESSION", str(tmp_path / "none.json"))
    assert completions(words) == []


def test_topics_and_their_types_are_those_of_the_running_simulation(monkeypatch):
    answers = {("rostopic", "list"): "/pose\n/cmd_vel\n", ("rostopic", "type", "/pose"): "a/Pose\n"}
    monkeypatch.setattr(completion, "find_session", lambda: "session")
    monkeypatch.setattr(
        completion, "run_in_session", lambda _session, words, show: show(answers[tuple(words)])
    )
    assert completions(["rostopic", "pub", "/"]) == ["/cmd_vel", "/pose"]
    assert completions(["rostopic", "pub", "-r", "/pose", ""]) == ["a/Pose"]


def test_only_commands_are_completed():
    assert set(completion._FOLLOWING) <= set(COMMANDS)
