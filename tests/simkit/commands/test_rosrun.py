"""rosrun: alone, and with other terminals."""

import signal
import time
from pathlib import Path

import pytest

TICKER = """
    import rospy, sys
    rospy.init_node('ticker')
    rospy.on_shutdown(lambda: print('goodbye', flush=True))
    print(rospy.get_name(), rospy.get_param('~speed', None), sys.argv[1:], flush=True)
    rate = rospy.Rate(10)
    for tick in range(1000):
        print('tick', flush=True)
        try:
            rate.sleep()
        except rospy.ROSInterruptException:
            break
    """


@pytest.fixture
def workspace(package, monkeypatch):
    """A workspace with the package `play`, as the working folder."""
    monkeypatch.chdir(package.folder)
    monkeypatch.delenv("SIMKIT_PACKAGE_PATH", raising=False)
    package("ticker.py", TICKER)
    return package


def _wait(condition, seconds=60.0):
    end = time.monotonic() + seconds
    while not condition() and time.monotonic() < end:
        time.sleep(0.05)
    return condition()


def test_a_node_runs_for_some_virtual_time(simkit, workspace):
    start = time.monotonic()
    code, out, err = simkit("rosrun", "play", "ticker.py", "--for", "80", "--fast")
    assert time.monotonic() - start < 60
    assert (code, err) == (0, "")
    assert out.splitlines()[:2] == ["/ticker None []", "tick"]
    assert out.count("tick\n") == 801


def test_the_wall_clock_sets_the_pace(simkit, workspace):
    start = time.monotonic()
    _, out, _ = simkit("rosrun", "--for", "0.5", "play", "ticker.py")
    assert time.monotonic() - start > 0.45
    assert out.count("tick\n") == 6


def test_the_nodes_own_words_reach_it(simkit, workspace):
    words = ("_speed:=2", "__name:=other", "--verbose", "x", "--for", "0", "--", "--fast")
    _, out, _ = simkit("rosrun", "play", "ticker.py", *words)
    assert out.splitlines()[0] == "/other 2 ['--verbose', 'x', '--fast']"


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("pass", 0),
        ("import sys\nsys.exit(3)", 3),
        ("1 / 0", 1),
        ("import os, signal\nos.kill(os.getpid(), signal.SIGKILL)", 1),
        ("import os\nos._exit(0)", 1),
    ],
)
def test_the_exit_code_is_the_nodes(simkit, workspace, text, code):
    workspace("ends.py", text)
    assert simkit("rosrun", "--fast", "play", "ends.py")[0] == code


def test_an_error_of_the_script_is_shown_once_without_our_frames(simkit, workspace):
    workspace("fails.py", "import rospy\nrospy.init_node('fails')\n1 / 0\n")
    code, out, err = simkit("rosrun", "--fast", "play", "fails.py")
    assert (code, err) == (1, "")
    assert 'File "play/scripts/fails.py", line 3, in <module>' in out
    assert out.count("Traceback") == 1
    assert "simkit/" not in out


def test_a_node_that_waits_for_ever_is_not_waited_for_in_a_hurry(simkit, workspace):
    workspace("waits.py", "import rospy\nrospy.init_node('waits')\nrospy.spin()\n")
    code, _, err = simkit("rosrun", "--fast", "play", "waits.py")
    assert (code, err) == (0, "/waits waits for ever: nothing else runs here\n")


@pytest.mark.parametrize(
    ("words", "code", "text"),
    [
        (("play", "tiker.py"), 1, "did you mean 'ticker.py'"),
        (("palyy", "ticker.py"), 1, "did you mean 'play'"),
        (("turtlesim", "turtlesim_nod"), 1, "did you mean 'turtlesim_node'"),
        (("play", "ticker.py", "--for", "soon"), 2, "'soon' is not a number of seconds"),
        (("--for", "-1", "play", "ticker.py"), 2, "'-1' is not a number of seconds"),
        (("--seed", "x", "play", "ticker.py"), 2, "--seed"),
        (("play", "ticker.py", "__name:=no/name"), 1, "__name:=no/name"),
    ],
)
def test_what_cannot_be_run_is_one_line(simkit, workspace, words, code, text):
    found, out, err = simkit("rosrun", *words)
    assert (found, out) == (code, "")
    assert text in err
    assert err.count("\n") == 1


def test_ctrl_c_lets_the_node_say_its_last_words_and_leaves_no_process(begin, workspace):
    mark = f"mark{time.monotonic_ns()}"
    process = begin("rosrun", "play", "ticker.py", mark, folder=workspace.folder)
    assert mark in process.stdout.readline()
    assert process.stdout.readline() == "tick\n"
    family = _descendants(process.pid)
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=60)
    assert (process.returncode, err) == (0, "")
    assert out.endswith("goodbye\n")
    if Path("/proc/self/task").exists():
        assert family
    assert _wait(lambda: not any(_runs(pid) for pid in family))


def test_a_stuck_node_does_not_keep_a_second_ctrl_c_waiting(begin, workspace):
    workspace("stuck.py", "print('here', flush=True)\nwhile True:\n    pass\n")
    process = begin("rosrun", "play", "stuck.py", folder=workspace.folder)
    assert _wait(lambda: _descendants(process.pid)) or not Path("/proc/self/task").exists()
    time.sleep(1.0)
    family = _descendants(process.pid)
    for _ in range(2):
        process.send_signal(signal.SIGINT)
        time.sleep(0.3)
    process.communicate(timeout=60)
    assert _wait(lambda: not any(_runs(pid) for pid in family))


def _descendants(pid):
    try:
        children = Path(f"/proc/{pid}/task/{pid}/children").read_text().split()
    except OSError:
        return []
    return [int(child) for child in children] + [
        other for child in children for other in _descendants(int(child))
    ]


def _runs(pid):
    try:
        state = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0]
    except OSError:
        return False
    return state != "Z"


def test_terminals_share_a_simulation(simkit, begin, workspace):
    host = begin("rosrun", "turtlesim", "turtlesim_node", folder=workspace.folder)
    assert _wait(lambda: simkit("rosnode", "list")[1] == "/turtlesim\n")
    joined = begin("rosrun", "play", "ticker.py", folder=workspace.folder)
    assert "/ticker" in joined.stdout.readline()
    assert simkit("rosnode", "list")[1] == "/ticker\n/turtlesim\n"
    code, out, _ = simkit("rosservice", "call", "/spawn", "{x: 1, y: 2, theta: 0, name: joe}")
    assert (code, out) == (0, 'name: "joe"\n')
    assert "/joe/pose\n" in simkit("rostopic", "list")[1]
    code, _, err = simkit("roscore")
    assert code == 1
    assert "running already" in err
    joined.send_signal(signal.SIGINT)
    joined.communicate(timeout=60)
    assert _wait(lambda: simkit("rosnode", "list")[1] == "/turtlesim\n")
    host.send_signal(signal.SIGINT)
    assert host.wait(timeout=60) == 0
    assert simkit("rosnode", "list")[0] == 1


def test_a_core_waits_for_others(simkit, begin):
    core = begin("roscore")
    assert "Ctrl-C ends it" in core.stdout.readline()
    assert _wait(lambda: simkit("rosparam", "set", "/x", "3")[0] == 0)
    assert simkit("rosparam", "get", "/x")[1] == "3\n"
    core.send_signal(signal.SIGINT)
    assert core.wait(timeout=60) == 0


@pytest.mark.parametrize("tool", ["rostopic", "rosnode", "rosservice", "rosparam"])
def test_without_a_simulation_the_tools_say_how_to_get_one(simkit, tool, tmp_path):
    code, out, err = simkit(tool, "list")
    assert (code, out) == (1, "")
    assert "no simulation runs; start one in another terminal" in err
    # what a host that was killed leaves behind
    (tmp_path / "session.json").write_text('{"port": 1, "token": "x", "pid": 1}')
    assert simkit(tool, "list")[0] == 1


def test_without_an_executable_those_of_the_package_are_listed(simkit, workspace):
    assert simkit("rosrun", "play") == (0, "ticker.py\n", "")
    code, out, _ = simkit("rosrun", "turtlesim")
    assert (code, out.split()) == (
        0,
        ["draw_square", "mimic", "turtle_teleop_key", "turtlesim_node"],
    )
