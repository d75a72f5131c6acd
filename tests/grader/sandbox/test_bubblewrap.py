"""What is possible inside of the sandbox, tried by a program that runs in it."""

import contextlib
import json
import os
import socket
import subprocess
import sys
import textwrap
import time
from dataclasses import replace
from pathlib import Path

import pytest

import simkit
from grader.sandbox import find_sandbox

ROOT = Path(simkit.__file__).parent.parent
COMMON = """
import errno, json, os, resource, socket, sys
from pathlib import Path

def attempt(deed):
    try:
        deed()
    except OSError as error:
        return errno.errorcode[error.errno]
    return "done"
"""


# Root can try the way of an ordinary user too; the other way round is impossible.
WAYS = [True, False] if os.getuid() == 0 else [False]


@pytest.fixture(params=WAYS, ids=lambda own_user: "as root" if own_user else "as a user")
def inside(tmp_path, request):
    """A function that runs a program in the sandbox and returns what it prints, as JSON."""
    sandbox = find_sandbox(private=(ROOT,))
    if sandbox.name != "bubblewrap":
        pytest.skip(f"no sandbox: {sandbox.reason}")
    sandbox = replace(sandbox, own_user=request.param)
    package_path = tmp_path / "work"
    package_path.mkdir()
    (package_path / "talk.py").write_text("print('hello')")
    confinement = sandbox.confine(package_path, tmp_path)

    def run(program, *arguments):
        text = COMMON + textwrap.dedent(program)
        command = [*confinement.command_prefix, sys.executable, "-c", text, *map(str, arguments)]
        done = subprocess.run(
            command, env=confinement.environment, capture_output=True, text=True, timeout=30
        )
        assert done.returncode == 0, done.stderr
        return json.loads(done.stdout)

    run.package_path = package_path
    run.confinement = confinement
    run.own_user = request.param
    return run


def test_simkit_and_the_package_are_there_and_nothing_else_of_the_workbook(inside):
    seen = inside(
        """
        import simkit, numpy
        root, package, home = map(Path, sys.argv[1:])
        print(json.dumps({
            "root": sorted(os.listdir(root)),
            "package": sorted(os.listdir(package)),
            "home": sorted(os.listdir(home)) if home.exists() else [],
            "top": sorted(os.listdir("/")),
            "grader": (root / "grader").exists(),
        }))
        """,
        ROOT,
        inside.package_path,
        Path.home(),
    )
    assert "simkit" in seen["root"]
    assert not set(seen["root"]) & {"grader", "exercises", "solutions", "tests", ".git", "work"}
    assert seen["package"] == ["talk.py"]
    assert ".ssh" not in seen["home"]
    assert set(seen["top"]) <= {
        *("bin", "dev", "etc", "lib", "lib32", "lib64", "proc", "sbin", "tmp", "usr"),
        *(Path(path).parts[1] for path in (ROOT, sys.prefix, sys.base_prefix, sys.executable)),
        Path(os.path.realpath(sys.executable)).parts[1],
        inside.package_path.parts[1],
    }


def test_the_grader_cannot_be_imported(inside):
    assert (
        inside("""
        try:
            import grader.results
            print('"imported"')
        except ImportError:
            print('"absent"')
    """)
        == "absent"
    )


def test_nothing_can_be_written_but_the_private_tmp(inside):
    outcomes = inside(
        """
        places = ["/x", "/usr/x", "/etc/x", "/dev/x", "/dev/shm/x", "/proc/x", *sys.argv[1:]]
        tried = {place: attempt(lambda: Path(place).write_text("x")) for place in places}
        print(json.dumps([tried, attempt(lambda: Path("/tmp/x").write_text("x"))]))
        """,
        inside.package_path / "x",
        inside.package_path / "talk.py",
        ROOT / "simkit" / "x",
        Path(sys.prefix) / "x",
    )
    assert set(outcomes[0].values()) <= {"EROFS", "EACCES", "ENOENT"}
    assert outcomes[1] == "done"
    assert (inside.package_path / "talk.py").read_text() == "print('hello')"


def test_tmp_is_small_and_gone_afterwards(inside):
    outcome = inside("""
        def fill():
            with open("/tmp/big", "wb") as file:
                for _ in range(200):
                    file.write(bytes(1 << 20))
        print(json.dumps(attempt(fill)))
    """)
    assert outcome == "ENOSPC"
    assert "big" not in inside('print(json.dumps(os.listdir("/tmp")))')


def test_there_is_no_network(inside):
    with socket_server() as port:
        outcomes = inside(
            """
            def connect(host, port):
                socket.create_connection((host, port), timeout=2).close()
            def datagram():
                socket.socket(socket.AF_INET, socket.SOCK_DGRAM).sendto(b"x", ("192.0.2.1", 53))
            print(json.dumps([
                attempt(lambda: connect("127.0.0.1", int(sys.argv[1]))),
                attempt(lambda: connect("192.0.2.1", 80)),
                attempt(datagram),
            ]))
            """,
            port,
        )
    assert outcomes[0] == "ECONNREFUSED"
    assert outcomes[1:] == ["ENETUNREACH", "ENETUNREACH"]


def test_no_process_outside_is_seen_or_reached(inside):
    seen = inside(
        """
        import signal
        pids = [int(name) for name in os.listdir("/proc") if name.isdigit()]
        print(json.dumps({
            "count": len(pids),
            "parent": attempt(lambda: os.kill(int(sys.argv[1]), signal.SIGTERM)),
            "environ": [attempt(lambda: Path(f"/proc/{pid}/environ").read_bytes())
                        for pid in pids if pid != os.getpid()],
            "secret": any("hunter2" in Path(f"/proc/{pid}/cmdline").read_text() for pid in pids),
            "user": os.getuid(),
        }))
        """,
        os.getpid(),
    )
    assert seen["count"] < 6
    assert seen["parent"] == "ESRCH"
    assert seen["user"] not in (0, os.getuid())


def test_the_environment_is_clean(inside, monkeypatch):
    monkeypatch.setenv("SECRET_TOKEN", "hunter2")
    text = inside("""
        def read(path):
            try:
                return Path(path).read_text()
            except OSError:
                return ""
        pids = [name for name in os.listdir("/proc") if name.isdigit()]
        print(json.dumps([str(os.environ), *[read(f"/proc/{pid}/environ") for pid in pids]]))
    """)
    assert "hunter2" not in str(text)


def test_the_number_of_processes_is_limited(inside):
    made = inside("""
        import signal, time
        resource.setrlimit(resource.RLIMIT_NPROC, (30, 30))
        pids = []
        try:
            for _ in range(200):
                pid = os.fork()
                if pid == 0:
                    time.sleep(60)
                    os._exit(0)
                pids.append(pid)
        except OSError:
            pass
        for pid in pids:
            os.kill(pid, signal.SIGKILL)
        print(json.dumps(len(pids)))
    """)
    if os.getuid() == 0 and not inside.own_user:
        assert made == 200  # which is why root takes the other way
    else:
        assert 10 < made < 30


def test_no_right_can_be_won(inside):
    outcomes = inside("""
        import ctypes
        libc = ctypes.CDLL(None, use_errno=True)
        def call(function, *arguments):
            if function(*arguments) != 0:
                raise OSError(ctypes.get_errno(), "refused")
        CLONE_NEWUSER, CLONE_NEWNS, MS_REMOUNT, MS_BIND = 0x10000000, 0x00020000, 32, 4096
        status = Path("/proc/self/status").read_text()
        print(json.dumps({
            "become root": attempt(lambda: os.setuid(0)),
            "user namespace": attempt(lambda: call(libc.unshare, CLONE_NEWUSER)),
            "mount namespace": attempt(lambda: call(libc.unshare, CLONE_NEWNS)),
            "remount": attempt(lambda: call(libc.mount, None, b"/", None, MS_REMOUNT, None)),
            "chroot": attempt(lambda: os.chroot("/tmp")),
            "no new privileges": "NoNewPrivs:\\t1" in status,
            "capabilities": "CapEff:\\t0000000000000000" in status,
        }))
    """)
    assert outcomes.pop("no new privileges")
    assert outcomes.pop("capabilities")
    assert set(outcomes.values()) <= {"EPERM", "EINVAL", "ENOSPC"}


def test_all_of_it_ends_with_whoever_started_it(inside, tmp_path):
    # A parent of the sandbox that is killed: what runs inside must not outlive it.
    if os.getuid() == 0 and not inside.own_user:
        pytest.skip("the kernel forgets the wish to die when root takes the way of a user")
    confinement = inside.confinement
    mark = f"1000.{os.getpid()}"
    inner = [*confinement.command_prefix, "sleep", mark]
    outer = f"import subprocess; subprocess.run({inner!r}, env={confinement.environment!r})"
    parent = subprocess.Popen([sys.executable, "-c", outer])
    wait_until(lambda: any(line.startswith("sleep") for line in processes_with(mark)))
    parent.kill()
    parent.wait()
    wait_until(lambda: not processes_with(mark))


def processes_with(word):
    """Command lines of the processes that have this word in theirs."""
    found = []
    for folder in Path("/proc").iterdir():
        with contextlib.suppress(OSError):
            if folder.name.isdigit() and word in (line := (folder / "cmdline").read_text()):
                found.append(line)
    return found


def wait_until(condition, seconds=10):
    deadline = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < deadline, "waited in vain"
        time.sleep(0.02)


@contextlib.contextmanager
def socket_server():
    """The port of a server on the loopback of this machine."""
    with socket.create_server(("127.0.0.1", 0)) as server:
        yield server.getsockname()[1]
