"""A small exercise, an honest solution of it, and a way to let an attack loose on its checks."""

import contextlib
import json
import os
import textwrap
import time
from dataclasses import dataclass
from pathlib import Path

import pytest

from grader.exercises import get_exercise
from grader.results import ExerciseResult
from grader.run import TimeLimits, WarmLauncher, grade_submission
from grader.sandbox import Sandbox, find_sandbox
from grader.submission import Submission
from simkit.graph.process import descendants

SCRIPT = "hello_ros/scripts/broadcaster.py"
SECRET = "hidden-secret-4711"
LIMITS = TimeLimits(check=15, exercise=30)
DEFINITION = {
    "id": "9.1",
    "title": "Broadcast",
    "package": "hello_ros",
    "files": [SCRIPT],
    "answers": [],
    "nodes_may": {"publish": ["/tf"], "services": [], "parameters": []},
}
CHECKS = '''
from grader.checks import expect_close, points
{secret}
@points({points})
def test_{name}(sim, run_node, rng):
    """The frame follows the turtle."""
    sim.rosrun("turtlesim", "turtlesim_node")
    run_node("broadcaster.py", "_turtle:=turtle1")
    speed, turn = rng.uniform(0.5, 2.0), rng.uniform(-1.0, 1.0)
    twist = {{"linear": {{"x": speed}}, "angular": {{"z": turn}}}}
    sim.rostopic_pub("/turtle1/cmd_vel", "geometry_msgs/Twist", twist, rate=10)
    sim.run(1.0)
    pose = sim.latest("/turtle1/pose")
    found = sim.tf.lookup_transform("world", "turtle1").transform.translation
    expect_close((found.x, found.y), (pose.x, pose.y), tolerance=0.05, what="the position", unit="m")
'''
HONEST = """
#!/usr/bin/env python3
import rospy
import tf
import turtlesim.msg

def handle(message):
    broadcaster.sendTransform(
        (message.x, message.y, 0),
        tf.transformations.quaternion_from_euler(0, 0, message.theta),
        rospy.Time.now(), name, "world")

rospy.init_node("broadcaster")
name = rospy.get_param("~turtle")
broadcaster = tf.TransformBroadcaster()
rospy.Subscriber("/%s/pose" % name, turtlesim.msg.Pose, handle)
rospy.spin()
"""


def released_notebook():
    source = f"%%writefile {SCRIPT}\n# TODO\n"
    cell = {"cell_type": "code", "id": "a", "metadata": {}, "outputs": [], "source": source}
    metadata = {"workbook": DEFINITION}
    return json.dumps({"cells": [cell], "metadata": metadata, "nbformat": 4, "nbformat_minor": 5})


@dataclass
class Attacked:
    """What came of an attack."""

    result: ExerciseResult
    seconds: float

    @property
    def text(self):
        """All that a student would see."""
        return self.result.dumps()


@dataclass
class Arena:
    """The exercise, and where it is graded."""

    root: Path
    launcher: WarmLauncher
    sandbox: Sandbox

    def attack(self, script, files=None):
        """Grade a script, public and hidden checks, and look for what is left of it."""
        files = {SCRIPT: textwrap.dedent(script).lstrip(), **(files or {})}
        submission = Submission(student="eve", exercise_id="9.1", files=files, answers={})
        exercise = get_exercise(self.root, "9.1")
        begin = time.monotonic()
        result = grade_submission(
            submission,
            exercise,
            hidden=True,
            sandbox=self.sandbox,
            launcher=self.launcher,
            limits=LIMITS,
        )
        seconds = time.monotonic() - begin
        await_end_of_all(self.launcher.server_pid)
        return Attacked(result, seconds)

    def honest(self):
        """The result of the honest solution."""
        return self.attack(HONEST).result.dumps()


@pytest.fixture(scope="session")
def course(tmp_path_factory):
    root = tmp_path_factory.mktemp("course")
    (root / "exercises").mkdir()
    (root / "solutions").mkdir()
    (root / "exercises/9_01_broadcast.ipynb").write_text(released_notebook())
    public = CHECKS.format(name="follows", points=2, secret="")
    hidden = CHECKS.format(name="follows_again", points=3, secret=f'SECRET = "{SECRET}"')
    (root / "exercises/test_9_01.py").write_text(public)
    (root / "solutions/test_9_01_hidden.py").write_text(hidden)
    return root


@pytest.fixture(scope="session")
def launcher():
    launcher = WarmLauncher()
    yield launcher
    launcher.close()


def await_end_of_all(pid):
    """The guard of a checker has said how it ended, and needs a moment to end itself."""
    deadline = time.monotonic() + 30
    while descendants(pid):
        assert time.monotonic() < deadline, "something is left"
        time.sleep(0.005)


@pytest.fixture(scope="session")
def arena_in(course, launcher):
    """A function that gives the arena in a sandbox, and watches what it leaves behind."""
    before = {}

    @contextlib.contextmanager
    def arena_in(sandbox):
        arena = Arena(course, launcher, sandbox)
        if sandbox.name not in before:
            before[sandbox.name] = arena.honest()
            assert ExerciseResult.loads(before[sandbox.name]).points == 5
        yield arena
        # Whatever was tried: the next submission is graded as if nothing had been.
        assert arena.honest() == before[sandbox.name]

    return arena_in


@pytest.fixture
def sandboxed(course, arena_in):
    """The arena in bubblewrap: for attacks that would harm this machine without it."""
    sandbox = find_sandbox(private=(course,))
    if sandbox.name != "bubblewrap":
        pytest.skip(f"no sandbox: {sandbox.reason}")
    with arena_in(sandbox) as arena:
        yield arena


@pytest.fixture(params=["bubblewrap", pytest.param("none", marks=pytest.mark.slow)])
def arena(request, course, arena_in):
    """The arena in each kind of isolation: for attacks that do no harm to this machine."""
    sandbox = find_sandbox(private=(course,))
    if request.param == "none":
        sandbox = Sandbox(name="none")
    elif sandbox.name != "bubblewrap":
        pytest.skip(f"no sandbox: {sandbox.reason}")
    with arena_in(sandbox) as arena:
        yield arena


@pytest.fixture
def marked():
    """A word for the command line of a process, and whether any process has it."""

    class Mark:
        word = f"98765.{os.getpid()}{time.monotonic_ns() % 10**6:06d}"

        def is_alive(self):
            for folder in Path("/proc").iterdir():
                try:
                    if folder.name.isdigit() and self.word in (folder / "cmdline").read_text():
                        return True
                except OSError:
                    continue
            return False

    return Mark()
