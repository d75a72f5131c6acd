"""roslaunch: alone, with other terminals, and what it lists."""

import io
import signal
import sys
import textwrap
import time

import pytest
import yaml

SLEEPER = """
    import rospy
    rospy.init_node('sleeper')
    rospy.on_shutdown(lambda: print('goodbye', flush=True))
    print('awake', rospy.get_name(), flush=True)
    rospy.spin()
    """
ENDER = """
    import rospy
    rospy.init_node('ender')
    rospy.sleep(0.5)
    print('ended', flush=True)
    """


@pytest.fixture
def workspace(package, monkeypatch):
    """A workspace with the package `play`, as the working folder; writes launch files into it."""
    monkeypatch.chdir(package.folder)
    monkeypatch.delenv("SIMKIT_PACKAGE_PATH", raising=False)
    package("sleeper.py", SLEEPER)
    package("ender.py", ENDER)
    (package.folder / "play/launch").mkdir()

    def write(name, inner):
        text = f"<launch>\n{textwrap.dedent(inner)}</launch>\n"
        (package.folder / "play/launch" / name).write_text(text)

    write.folder = package.folder
    write(
        "ends.launch",
        '<param name="a" value="1"/><node name="e" pkg="play" type="ender.py" output="screen"/>',
    )
    write(
        "stays.launch",
        """<arg name="name" default="s"/>
        <node name="$(arg name)" pkg="play" type="sleeper.py" output="screen"/>
        <node name="turtle" pkg="turtlesim" type="turtlesim_node"/>""",
    )
    write("only.launch", '<param name="robot" value="r2"/>')
    return write


def _wait(condition, seconds=60.0):
    end = time.monotonic() + seconds
    while not condition() and time.monotonic() < end:
        time.sleep(0.05)
    return condition()


def test_until_all_nodes_have_ended(simkit, workspace):
    code, out, err = simkit("roslaunch", "play", "ends.launch", "--fast")
    assert (code, err) == (0, "")
    assert out == (
        "started a simulation\n\nSUMMARY\n========\n\nPARAMETERS\n * /a: 1\n\nNODES\n  /\n"
        "    e (play/ender.py)\n\nprocess[e-1]: started play/ender.py\nended\n"
        "[e-1] process has finished cleanly\n"
        "all processes on machine have died, roslaunch will exit\n"
        "shutting down processing monitor...\n... shutting down processing monitor complete\ndone\n"
    )


def test_for_some_virtual_time_by_its_path_and_with_arguments(simkit, workspace):
    words = ("--for", "2", "--fast", "play/launch/stays.launch", "name:=other", "--seed", "3")
    code, out, err = simkit("roslaunch", *words)
    assert (code, err) == (0, "")
    assert "    other (play/sleeper.py)\n    turtle (turtlesim/turtlesim_node)\n" in out
    assert out.count("awake /other") == 1
    assert "Spawning turtle" not in out  # its <node> has no output="screen"
    assert "Spawning turtle" in simkit("roslaunch", "--screen", *words)[1]


def test_nodes_that_wait_for_ever_are_not_waited_for_in_a_hurry(simkit, workspace):
    workspace("wait.launch", '<node name="s" pkg="play" type="sleeper.py"/>')
    code, _, err = simkit("roslaunch", "play", "wait.launch", "--fast")
    assert (code, err) == (0, "/s waits for ever: nothing else runs here\n")


def test_what_roslaunch_refuses_is_told_in_both_layers(simkit, workspace):
    workspace("bad.launch", '<node nam="t" pkg="p" type="x"/>')
    code, out, err = simkit("roslaunch", "play", "bad.launch", "--fast")
    assert (code, out) == (1, "")
    lines = err.splitlines()
    assert lines[0].startswith(
        "RLException: <node> tag is missing required attribute: 'name'. Node"
    )
    assert lines[1].startswith("play/launch/bad.launch:2:2: error [LCH-E07] ")
    assert "Write name= where nam= stands." in err
    assert "Traceback" not in err


@pytest.mark.parametrize(
    ("words", "code", "text"),
    [
        (("play", "ned.launch"), 1, "[ned.launch] is neither a launch file in package [play]"),
        (("nope.launch",), 1, "[nope.launch] is not a launch file name"),
        ((), 1, "which launch file?"),
        (("play", "ends.launch", "a=1"), 1, "Write a:=1, with a colon"),
        (("play", "ends.launch", "-v"), 1, "'-v' is no argument, and no option"),
        (("play", "ends.launch", "--for", "soon"), 2, "'soon' is not a number of seconds"),
        (("play", "ends.launch", "--args", "/x"), 1, "Cannot find node named [/x]"),
    ],
)
def test_what_cannot_be_launched(simkit, workspace, words, code, text):
    found, out, err = simkit("roslaunch", *words)
    assert (found, out) == (code, "")
    assert text in err


def test_nothing_could_be_started(simkit, workspace):
    workspace("none.launch", '<node name="t" pkg="play" type="nope.py"/>')
    code, out, _ = simkit("roslaunch", "play", "none.launch", "--fast")
    assert code == 1
    assert "ERROR: cannot launch node of type [play/nope.py]: Cannot locate node" in out
    assert out.endswith(
        "No processes to monitor\nshutting down processing monitor...\n"
        "... shutting down processing monitor complete\n"
    )


def test_a_required_node_takes_the_rest_with_it(simkit, workspace):
    workspace(
        "required.launch",
        """<node name="s" pkg="play" type="sleeper.py"/>
        <node name="e" pkg="play" type="ender.py" required="true"/>""",
    )
    code, out, _ = simkit("roslaunch", "play", "required.launch", "--fast")
    assert code == 1
    assert "REQUIRED process [e-2] has died!\nprocess has finished cleanly\nInitiating" in out
    assert out.endswith(
        "[s-1] killing on exit\nshutting down processing monitor...\n"
        "... shutting down processing monitor complete\ndone\n"
    )


def test_lists(simkit, workspace):
    folder = workspace.folder / "play"
    launch = folder / "launch/ends.launch"
    for option, text in {
        "--dump-params": "/a: 1\n\n",
        "--nodes": "/e\n",
        "--files": f"{launch}\n",
        "--ros-args": "No arguments.\n",
    }.items():
        assert simkit("roslaunch", "play", "ends.launch", option) == (0, text, "")
    script = folder / "scripts/ender.py"
    assert simkit("roslaunch", "--args", "e", "play", "ends.launch")[1] == f"{script} __name:=e\n"
    assert simkit("roslaunch", "--find-node", "/e", "play", "ends.launch")[1] == f"{launch}\n"


STANDARD_INPUT = '<launch><arg name="a" default="1"/><param name="a" value="$(arg a)"/></launch>'


@pytest.fixture
def standard_input(monkeypatch):
    """A function that puts bytes on standard input."""

    def put(data):
        monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(data), encoding="utf-8"))

    return put


def test_a_launch_file_on_standard_input(simkit, workspace, standard_input):
    standard_input(STANDARD_INPUT.encode())
    assert simkit("roslaunch", "--dump-params", "-", "a:=2")[:2] == (0, "/a: 2\n\n")
    standard_input(STANDARD_INPUT.encode())
    code, out, _ = simkit("roslaunch", "-", "--for", "0.1")
    assert code == 0
    assert out.startswith("Passed '-' as file argument, attempting to read roslaunch XML from ")
    assert f"... {len(STANDARD_INPUT)} bytes read successfully.\n" in out
    assert " * /a: 1\n" in out


@pytest.mark.parametrize(
    ("data", "text"),
    [
        (b"", "standard input holds no launch file"),
        (b"hello", "standard input holds no launch file"),
        (b"<launch><node/></launch>", "<launch file>:1:10: error [LCH-E07]"),
        (b"\xff<launch/>", "LCH-E04"),
    ],
)
def test_what_is_no_launch_file_on_standard_input(simkit, workspace, standard_input, data, text):
    standard_input(data)
    code, _, err = simkit("roslaunch", "--nodes", "-")
    assert code == 1
    assert text in err


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGHUP])
def test_whoever_wants_an_end_gets_an_orderly_one(begin, workspace, number):
    process = begin("roslaunch", "play", "stays.launch", folder=workspace.folder)
    assert any(line == "awake /s\n" for line in iter(process.stdout.readline, ""))
    process.send_signal(number)
    out, err = process.communicate(timeout=60)
    assert (process.returncode, err) == (0, "")
    assert "[s-1] killing on exit\ngoodbye\n" in out
    assert out.endswith("done\n")


def test_ctrl_c_ends_all(begin, workspace):
    process = begin("roslaunch", "play", "stays.launch", folder=workspace.folder)
    lines = iter(process.stdout.readline, "")
    assert next(lines).startswith("started a simulation; other terminals join it")
    assert any(line == "awake /s\n" for line in lines)
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=60)
    assert (process.returncode, err) == (0, "")
    assert out == (
        "[turtle-2] killing on exit\n[s-1] killing on exit\ngoodbye\n"
        "shutting down processing monitor...\n... shutting down processing monitor complete\ndone\n"
    )


def test_a_launch_joins_the_simulation_of_another_terminal(
    simkit, begin, workspace, tmp_path, monkeypatch, standard_input
):
    core = begin("roscore", folder=workspace.folder)
    assert "Ctrl-C ends it" in core.stdout.readline()
    assert _wait(lambda: simkit("rosnode", "list")[0] == 0)
    code, out, _ = simkit("roslaunch", "play", "only.launch")  # exercise 3.6: parameters, no nodes
    assert code == 0
    assert out.startswith("joined the simulation of another terminal\n\nSUMMARY\n")
    assert out.endswith(
        "No processes to monitor\nshutting down processing monitor...\n"
        "... shutting down processing monitor complete\n"
    )
    assert simkit("rosparam", "get", "/robot")[1] == "r2\n"
    monkeypatch.chdir(tmp_path)  # rosparam's files are those of its own terminal
    (tmp_path / "own.yaml").write_text("own: 1\n")
    assert simkit("rosparam", "load", "own.yaml", "/mine")[:2] == (0, "")
    assert simkit("rosparam", "set", "-t", "own.yaml", "/text")[0] == 0
    assert simkit("rosparam", "dump", "dumped.yaml")[0] == 0
    assert yaml.safe_load((tmp_path / "dumped.yaml").read_text())["mine"] == {"own": 1}
    monkeypatch.chdir(workspace.folder)
    standard_input(STANDARD_INPUT.encode())
    assert simkit("roslaunch", "-", "a:=7")[0] == 0
    assert simkit("rosparam", "get", "/a")[1] == "7\n"
    code, out, _ = simkit("roslaunch", "play/launch/ends.launch")
    assert (code, "ended\n" in out) == (0, True)
    joined = begin("roslaunch", "play", "stays.launch", folder=workspace.folder)
    assert any(line == "awake /s\n" for line in iter(joined.stdout.readline, ""))
    assert simkit("rosnode", "list")[1] == "/s\n/turtle\n"
    code, _, err = simkit("roslaunch", "play", "nope.launch")
    assert code == 1
    assert err.startswith("RLException: [nope.launch] is neither a launch file")
    joined.send_signal(signal.SIGINT)
    joined.communicate(timeout=60)
    assert _wait(lambda: simkit("rosnode", "list")[1] == "\n")
    core.send_signal(signal.SIGINT)
    assert core.wait(timeout=60) == 0


def test_packages_are_those_of_the_terminal_that_asks(simkit, begin, workspace, tmp_path):
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    core = begin("roscore", folder=elsewhere)
    assert "Ctrl-C ends it" in core.stdout.readline()
    assert _wait(lambda: simkit("rosnode", "list")[0] == 0)
    code, out, err = simkit("roslaunch", "play", "ends.launch")
    assert (code, err) == (0, "")
    assert "ended\n" in out
    assert "ended\n" in simkit("rosrun", "play", "ender.py")[1]


def test_without_nodes_it_stays_for_others_as_with_a_master_of_its_own(simkit, begin, workspace):
    host = begin("roslaunch", "play", "only.launch", folder=workspace.folder)
    assert any("the parameters are set" in line for line in iter(host.stdout.readline, ""))
    assert _wait(lambda: simkit("rosparam", "get", "/robot")[1] == "r2\n")
    host.send_signal(signal.SIGINT)
    out, _ = host.communicate(timeout=60)
    assert host.returncode == 0
    assert out.endswith("done\n")
