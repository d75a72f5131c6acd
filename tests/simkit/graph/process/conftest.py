"""Fakes: a node process that need not be one at all, and a graph that is nothing but a clock."""

import contextlib
import os
import socket
import threading
from pathlib import Path

import pytest

from simkit.graph import Executor, Graph
from simkit.graph.names import CommandLine
from simkit.graph.process import NodeLimits, Permissions, ScriptNode, StartSpec
from simkit.graph.process.scheduler import Scheduler
from simkit.graph.process.starters import StartedProcess, Starter
from simkit.msgs import message_class


class FakeStarter(Starter):
    """Has no process: what a node is told to do about it is only noted."""

    def __init__(self):
        self.ended = []

    def start(self, spec):
        raise NotImplementedError

    def signal(self, pid, number):
        """Nobody is there."""

    def usage(self, pid):
        return None

    def end(self, pid, *, kill):
        self.ended.append(kill)
        return 0

    def close(self):
        """Nothing to close."""


class FakeRuntime:
    """Starts nodes whose end of the line is in the test's hands."""

    def __init__(self, allowance=2.0):
        self.allowance = allowance
        self.limits = NodeLimits(output_bytes=10_000)
        self.starter = FakeStarter()
        self.line, self._connection = socket.socketpair()
        self._output, self.printer = os.pipe()

    def start(self, spec):
        return StartedProcess(self._connection, self._output, None, 1, self.starter)

    def close(self):
        self.line.close()
        self._connection.close()
        for fd in (self._output, self.printer):
            with contextlib.suppress(OSError):
                os.close(fd)


class Stage:
    """A graph with an honest node and a fake one."""

    def __init__(self, *, allowance=60.0, permissions=None):
        self.graph = Graph(Executor())
        self.runtime = FakeRuntime(allowance)
        self.number = message_class("std_msgs/Int32")
        self.honest = self.graph.create_node("/honest")
        self.heard = []
        self.honest.subscribe("/numbers", self.number, lambda m: self.heard.append(m.data))
        self.mouth = self.honest.advertise("/numbers", self.number)
        self.fake = ScriptNode(
            self.graph,
            self.runtime,
            StartSpec(script=str(Path("fake.py")), shown_path="play/fake.py"),
            CommandLine(),
            permissions or Permissions(),
        )

    def run(self, seconds=0.0):
        self.graph.executor.run_to(self.graph.executor.now_ns + round(seconds * 1e9))

    def answer_with(self, respond):
        """Send `respond(data)` for whatever comes, first for nothing, until it gives None."""

        def serve():
            data = b""
            with contextlib.suppress(OSError):
                while (answer := respond(data)) is not None:
                    self.runtime.line.sendall(answer)
                    data = self.runtime.line.recv(1 << 20)
                    if not data:
                        break
                self.runtime.line.shutdown(socket.SHUT_RDWR)

        thread = threading.Thread(target=serve, daemon=True)
        thread.start()
        return thread

    def require_sound(self):
        """The rest of the graph goes on as if nothing had been."""
        del self.heard[:]
        self.mouth.publish(self.number(42))
        self.run(0.001)
        assert self.heard == [42]

    def close(self):
        self.fake.close()
        self.runtime.close()


@pytest.fixture
def make_stage():
    """A function that makes a stage; all are closed afterwards."""
    stages = []

    def make(**options):
        stages.append(Stage(**options))
        return stages[-1]

    yield make
    for stage in stages:
        stage.close()


@pytest.fixture
def stage(make_stage):
    return make_stage()


class Clock:
    """What the graph is to a scheduler: it answers a wait with the time waited for."""

    def __init__(self):
        self.now_ns = 0
        self.waits = []
        self.on_wait = None
        self.scheduler = Scheduler(self.exchange, lambda: self.now_ns)

    def exchange(self, wake_ns):
        self.waits.append(wake_ns)
        if self.on_wait is not None:
            self.on_wait()
        elif wake_ns is None:
            raise RuntimeError("everybody waits for ever")
        if wake_ns is not None:
            self.now_ns = max(self.now_ns, wake_ns)

    def sleep(self, duration_ns):
        end = self.now_ns + duration_ns
        while self.now_ns < end:
            self.scheduler.block(end)


@pytest.fixture
def make_clock():
    """A function that makes a clock with a scheduler of its own; the test is its main task."""
    return Clock


@pytest.fixture
def clock():
    return Clock()
