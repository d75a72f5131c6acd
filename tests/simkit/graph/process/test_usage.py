"""How much of a processor a process has had."""

import os
import subprocess
import sys
import time

import pytest

from simkit.graph.process.usage import usage_of

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="only Linux tells it")

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
