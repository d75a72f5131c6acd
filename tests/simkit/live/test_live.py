"""A simulation in one terminal, used from others."""

import json
import socket
import subprocess
import sys
import textwrap
import threading
import time

import pytest

from simkit.live.client import run_in_session
from simkit.live.session import Session, SessionError, find_session

HOST = """
    import os, sys
    from simkit import Simulation
    from simkit.commands.rosrun import run as rosrun
    from simkit.live.host import Host

    def time(call):
        yield f"{call.sim.now.to_sec():.3f}\\n"

    def where(call):
        yield os.getcwd()

    sim = Simulation(package_path=[sys.argv[1]], screen=None)
    print("up", flush=True)
    Host(sim, {"rosrun": rosrun, "time": time, "where": where}).serve(lambda: False)
    sim.close()
    """


@pytest.fixture
def host(package, tmp_path, monkeypatch):
    monkeypatch.setenv("SIMKIT_SESSION", str(tmp_path / "session.json"))
    process = subprocess.Popen(
        [sys.executable, "-c", textwrap.dedent(HOST), str(package.folder)],
        stdout=subprocess.PIPE,
        text=True,
    )
    assert process.stdout.readline() == "up\n"
    for _ in range(100):
        if find_session() is not None:
            break
        time.sleep(0.05)
    yield process
    process.terminate()
    process.wait()
    process.stdout.close()


def say(*argv):
    pieces = []
    return run_in_session(find_session(), argv, pieces.append), "".join(pieces)


def test_time_goes_at_the_pace_of_the_clock(host):
    before, (_, first), heard = time.monotonic(), say("time"), time.monotonic()
    time.sleep(0.5)
    asked, (_, second), after = time.monotonic(), say("time"), time.monotonic()
    virtual = float(second) - float(first)
    # An answer is of some moment while it was waited for; on a busy machine the simulation may lag.
    assert 0.5 * (asked - heard) <= virtual <= after - before + 0.05


def test_a_node_speaks_to_its_own_terminal_and_ends_with_it(host, package):
    package(
        "once.py",
        "import rospy\nrospy.init_node('once')\nprint('hello')\nrospy.loginfo('logged')\n",
    )
    package("fail.py", "import rospy\nrospy.init_node('fail')\n1 / 0\n")
    code, text = say("rosrun", "play", "once.py")
    assert code == 0
    assert "hello\n" in text
    assert "logged" in text
    code, text = say("rosrun", "play", "fail.py")
    assert code == 1
    assert "ZeroDivisionError" in text


def test_two_terminals_at_once(host, package):
    package(
        "tick.py",
        "import rospy\nrospy.init_node('tick')\nfor i in range(5):\n    rospy.sleep(0.1)\n    print(i)\n",
    )
    results = []
    threads = [
        threading.Thread(
            target=lambda n=n: results.append(say("rosrun", "play", "tick.py", f"__name:={n}"))
        )
        for n in ("a", "b")
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(timeout=30)
    assert results == [(0, "0\n1\n2\n3\n4\n")] * 2


def test_a_command_is_done_in_the_folder_of_its_terminal(host, tmp_path, monkeypatch):
    for name in ("one", "two"):
        (tmp_path / name).mkdir()
        monkeypatch.chdir(tmp_path / name)
        assert say("where") == (0, str(tmp_path / name))
    with monkeypatch.context() as patch:
        patch.setattr("pathlib.Path.cwd", lambda: tmp_path / "gone")
        with pytest.raises(SessionError, match="gone"):
            say("where")
    assert say("time")[0] == 0


@pytest.mark.usefixtures("host")
def test_a_program_writes_its_files_where_it_was_started(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert say("rosrun", "tf2_tools", "view_frames.py")[0] == 0
    assert {"frames.gv", "frames.pdf"} <= {file.name for file in tmp_path.iterdir()}


def test_errors_are_one_sentence(host):
    with pytest.raises(SessionError, match="did you mean 'rosrun'"):
        say("rosrn")
    with pytest.raises(SessionError, match="package"):
        say("rosrun", "nothing", "x.py")


def test_who_does_not_know_the_secret_gets_nothing(host):
    session = find_session()
    with socket.create_connection(("127.0.0.1", session.port)) as connection:
        connection.sendall(json.dumps({"token": "guess", "argv": ["time"]}).encode() + b"\n")
        assert connection.recv(100) == b""
    assert say("time")[0] == 0


def test_an_ended_simulation_is_named(host):
    session = find_session()
    host.terminate()
    host.wait()
    with pytest.raises(SessionError, match="has ended"):
        run_in_session(session, ["time"], print)
    with pytest.raises(SessionError, match="has ended"):
        run_in_session(Session(port=1, token="x", pid=1), ["time"], print)
