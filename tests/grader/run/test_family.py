import os
import subprocess
import sys
import time
from pathlib import Path

import pytest

from grader.run.family import descendants

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="only Linux tells of children")

# A process of its own becomes the reaper of orphans, has a child that leaves a grandchild in
# another session and forks as fast as it can, and ends them all.
PROGRAM = """
import ctypes, os, resource, sys, time
from grader.run.family import end_family, descendants
resource.setrlimit(resource.RLIMIT_CPU, (10, 10))
ctypes.CDLL(None).prctl(36, 1, 0, 0, 0)
child = os.fork()
if child == 0:
    if os.fork() == 0:
        os.setsid()
        if os.fork() == 0:
            time.sleep(1000)
        os._exit(0)
    made = 0
    while made < 50:
        if os.fork() == 0:
            time.sleep(1000)
        made += 1
    os._exit(3)
time.sleep(0.3)
before = descendants(os.getpid())
code = end_family(child)
print(len(before), code, len(descendants(os.getpid())))
print(*before)
"""


def test_all_that_came_from_a_child_ends():
    done = subprocess.run(
        [sys.executable, "-c", PROGRAM], capture_output=True, text=True, timeout=30, check=True
    )
    first, pids = done.stdout.splitlines()
    before, code, after = first.split()
    assert int(before) >= 51
    assert (code, after) == ("3", "0")
    assert not [pid for pid in pids.split() if Path(f"/proc/{pid}").exists()]


def test_descendants_are_found_at_every_depth():
    shell = subprocess.Popen(["sh", "-c", "sh -c 'sleep 1000; true'; true"])
    try:
        deadline = time.monotonic() + 5
        while len(descendants(shell.pid)) < 2 and time.monotonic() < deadline:
            time.sleep(0.01)
        found = descendants(shell.pid)
        assert len(found) == 2
        assert set(found) <= set(descendants(os.getpid()))
    finally:
        for pid in [shell.pid, *descendants(shell.pid)]:
            os.kill(pid, 9)
        shell.wait()
