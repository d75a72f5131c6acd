import os
import subprocess
import sys
import time
from pathlib import Path

import pytest

from simkit.graph.process.process_tree import descendants, usage_of

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="only Linux tells of children")

# A process of its own becomes the reaper of orphans, has a child that leaves a grandchild in
# another session and forks as fast as it can, and ends them all.
PROGRAM = """
import ctypes, os, resource, sys, time
from simkit.graph.process.process_tree import descendants, end_tree
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
os.waitid(os.P_PID, child, os.WEXITED | os.WNOWAIT)
deadline = time.monotonic() + 20
while len(before := descendants(os.getpid())) < 51 and time.monotonic() < deadline:
    time.sleep(0.02)
code = end_tree(child)
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


# -- how much of a processor a process has had


BUSY = "print(flush=True)\nwhile True: pass"
IDLE = "print(flush=True)\nimport time\ntime.sleep(1000)"
HIDDEN = """
import threading, time
def work():
    print(flush=True)
    while True: pass
threading.Thread(target=work).start()
time.sleep(1000)
"""


@pytest.fixture
def start():
    processes = []

    def make(script):
        process = subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE)
        processes.append(process)
        process.stdout.readline()
        return process

    yield make
    for process in processes:
        process.kill()
        process.wait()
        process.stdout.close()


@pytest.mark.parametrize("script", [BUSY, HIDDEN])
def test_one_that_computes_is_seen_to_compute_in_whatever_thread(start, script):
    process = start(script)
    before = usage_of(process.pid).cpu_s
    while usage_of(process.pid).cpu_s < before + 0.1:
        time.sleep(0.01)
    assert usage_of(process.pid).is_computing


def test_one_that_waits_does_not_compute(start):
    process = start(IDLE)
    while usage_of(process.pid).is_computing:
        time.sleep(0.01)
    used = usage_of(process.pid).cpu_s
    time.sleep(0.1)
    assert usage_of(process.pid).cpu_s == used


def test_nobody_knows_of_one_that_is_gone(start):
    process = start(IDLE)
    process.kill()
    process.wait()
    assert usage_of(process.pid) is None


def test_a_name_may_hold_anything(tmp_path):
    odd = tmp_path / "a) R (b"
    odd.symlink_to(sys.executable)
    process = subprocess.Popen([odd, "-c", "input()"], stdin=subprocess.PIPE)
    try:
        assert usage_of(process.pid).cpu_s < 1000
    finally:
        process.communicate(b"\n")


def test_it_is_the_time_of_the_operating_system():
    begin = os.times()
    usage = usage_of(os.getpid())
    end = os.times()
    tick = 1 / os.sysconf("SC_CLK_TCK")
    assert begin.user + begin.system - 2 * tick <= usage.cpu_s <= end.user + end.system + 2 * tick
