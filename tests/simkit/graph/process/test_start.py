"""How node processes begin and end, in each of the ways there are."""

import os
import signal
import socket
import subprocess
import sys
import threading
import time
from pathlib import Path

import pytest

from simkit.graph.process import NodeRuntime, StartError, StartSpec, starters
from simkit.graph.process.fork_server import HAS_FORK, clean_environment
from simkit.graph.process.protocol import FrameReader, Op, receive_frame, records, unpack_json
from simkit.graph.process.starters import SpawnStarter

METHODS = [
    pytest.param(
        "fork", marks=pytest.mark.skipif(not HAS_FORK, reason="no safe fork on this platform")
    ),
    "spawn",
]


@pytest.fixture(params=METHODS)
def runtime(request):
    runtime = NodeRuntime(method=request.param, environment={"GREETING": "hello"})
    yield runtime
    runtime.close()


@pytest.fixture
def start(runtime, tmp_path):
    """A function that starts a script given as text."""

    def start(text, **options):
        (tmp_path / "script.py").write_text(text)
        spec = StartSpec(script=str(tmp_path / "script.py"), shown_path="play/script.py", **options)
        return runtime.start(spec)

    return start


def _last_words(process):
    """What the node says at its end: exit code and failure."""
    process.connection.settimeout(20)
    frame = receive_frame(process.connection, FrameReader())
    ((op, body),) = records(frame)
    assert op is Op.EXIT
    return unpack_json(body)


def _finish(process, *, kill=False):
    """Exit code and output of a process."""
    code = process.end(kill=kill)
    output = process.output
    if isinstance(output, socket.socket):
        output.settimeout(5)
        text = b"".join(iter(lambda: output.recv(65536), b""))
        output.close()
    else:
        text = b"".join(iter(lambda: os.read(output, 65536), b""))
        os.close(output)
    process.connection.close()
    if process.trace_fd is not None:
        os.close(process.trace_fd)
    return code, text.decode()


def test_a_script_runs_with_its_name_arguments_and_folder(start, tmp_path):
    text = "import os, sys\nprint(__name__, __file__, sys.argv[1:], os.getcwd(), sys.stdin.read())"
    process = start(text, arguments=("a", "b"))
    assert _last_words(process) == {"code": 0, "failure": None}
    code, output = _finish(process)
    assert code == 0
    assert output == f"__main__ play/script.py ['a', 'b'] {tmp_path} \n"


def test_exit_codes_and_failures_are_told(start):
    process = start("import sys\nsys.exit(7)")
    assert _last_words(process) == {"code": 7, "failure": None}
    assert _finish(process)[0] == 7
    process = start("def f():\n    1 / 0\nf()")
    words = _last_words(process)
    assert (words["code"], words["failure"]["line"], words["failure"]["function"]) == (1, 2, "f")
    code, output = _finish(process)
    assert code == 1
    assert "simkit" not in output


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux tells how much a process has used")
def test_one_is_told_how_much_of_a_processor_a_node_has_had(start):
    process = start("while True: pass")
    while process.usage().cpu_s < 0.1:
        time.sleep(0.01)
    assert process.usage().is_computing
    _finish(process, kill=True)
    assert process.usage() is None


def test_a_script_can_import_what_lies_beside_it_and_the_ros_modules(start, tmp_path):
    (tmp_path / "helper.py").write_text("VALUE = 42")
    text = (
        "import helper, rospy, tf, std_msgs.msg\nprint(helper.VALUE, std_msgs.msg.String('x').data)"
    )
    process = start(text)
    assert _last_words(process)["failure"] is None
    assert _finish(process)[1] == "42 x\n"


def test_the_environment_is_clean_but_for_what_was_given(start, monkeypatch):
    monkeypatch.setenv("SECRET_TOKEN", "x")
    process = start("import os\nprint(sorted(os.environ))")
    _last_words(process)
    names = eval(_finish(process)[1])
    assert "GREETING" in names
    assert "SECRET_TOKEN" not in names
    assert set(names) <= {*clean_environment({}), "GREETING", "LC_CTYPE"}


def test_hashes_and_dice_are_the_same_in_every_way(start):
    text = "import random, numpy\nprint(hash('a'), random.random(), numpy.random.rand())"
    outputs = set()
    for seed in (1, 1, 2):
        process = start(text, seed=seed)
        _last_words(process)
        outputs.add(_finish(process)[1])
    assert len(outputs) == 2
    assert len({output.split()[0] for output in outputs}) == 1


def test_a_killed_process_says_by_what(start):
    process = start("while True:\n    pass")
    assert _finish(process, kill=True)[0] == -signal.SIGKILL


def test_closing_the_runtime_ends_every_process(runtime, start):
    processes = [start("while True:\n    pass") for _ in range(2)]
    runtime.close()
    for process in processes:
        process.connection.settimeout(10)
        assert process.connection.recv(1) == b""
        _close_lines(process)


def _close_lines(process):
    process.connection.close()
    if isinstance(process.output, socket.socket):
        process.output.close()
    else:
        os.close(process.output)
    if process.trace_fd is not None:
        os.close(process.trace_fd)


def test_a_closed_runtime_starts_again(runtime, start):
    for _ in range(2):
        process = start("print('up')")
        _last_words(process)
        assert _finish(process)[1] == "up\n"
        runtime.close()


@pytest.mark.parametrize("method", METHODS)
def test_a_prefix_that_cannot_run_is_a_start_error(method, tmp_path):
    spec = StartSpec(script=str(tmp_path / "x.py"), shown_path="x.py")
    for prefix in (
        ["no-such-program"],
        ["false"],
        [sys.executable, "-c", "raise SystemExit('no')"],
    ):
        runtime = NodeRuntime(prefix, method=method)
        start = time.monotonic()
        with pytest.raises(StartError, match=r"cannot start|has died"):
            runtime.start(spec)
        assert time.monotonic() - start < 10
        runtime.close()


@pytest.mark.skipif(not HAS_FORK, reason="there is no fork server on this platform")
def test_a_fork_server_that_was_killed_is_replaced(tmp_path):
    (tmp_path / "x.py").write_text("print('up')")
    spec = StartSpec(script=str(tmp_path / "x.py"), shown_path="x.py")
    runtime = NodeRuntime(method="fork")
    runtime.warm_up()
    server = runtime._starter
    os.killpg(server.server_pid, signal.SIGKILL)
    while server.alive:
        time.sleep(0.001)
    process = runtime.start(spec)
    _last_words(process)
    assert _finish(process)[1] == "up\n"
    runtime.close()


@pytest.mark.skipif(not HAS_FORK, reason="there is no fork server on this platform")
def test_nodes_of_another_copy_of_simkit_are_refused_with_its_place(tmp_path, monkeypatch):
    monkeypatch.setattr(starters, "SIMKIT", "/elsewhere/simkit")
    runtime = NodeRuntime(method="fork")
    with pytest.raises(
        StartError, match=r"this simulation that of /elsewhere/simkit.*Run `make` here"
    ):
        runtime.start(StartSpec(script=str(tmp_path / "x.py"), shown_path="x.py"))
    runtime.close()


def test_a_stranger_at_the_port_is_turned_away(tmp_path, monkeypatch):
    (tmp_path / "x.py").write_text("print('up')")
    ports, create_server = [], socket.create_server

    def create(address):
        server = create_server(address)
        ports.append(server.getsockname()[1])
        stranger = socket.create_connection(server.getsockname())
        stranger.sendall(b"x" * 32)
        threading.Timer(1.0, stranger.close).start()
        return server

    monkeypatch.setattr(socket, "create_server", create)
    starter = SpawnStarter([], {})
    process = starter.start(StartSpec(script=str(tmp_path / "x.py"), shown_path="x.py"))
    assert _last_words(process) == {"code": 0, "failure": None}
    assert _finish(process) == (0, "up\n")
    assert len(ports) == 1


@pytest.mark.skipif(not Path("/proc/self/fd").exists(), reason="counts descriptors by /proc")
def test_starting_and_ending_leaves_no_descriptor_behind(runtime, start):
    def descriptors():
        return len(list(Path("/proc/self/fd").iterdir()))

    for turn in range(4):
        process = start("pass")
        _last_words(process)
        _finish(process)
        if turn == 1:
            before = descriptors()
    for _ in range(100):  # a thread that forwards output closes its end in its own time
        if descriptors() <= before:
            break
        time.sleep(0.02)
    assert descriptors() <= before


def test_simkit_alone_imports_no_numpy():
    code = "import sys, simkit.graph.process.zygote\nprint('numpy' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == "False\n"
