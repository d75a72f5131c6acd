"""What a check can ask for by naming it as an argument."""

from __future__ import annotations

import hashlib
import random
from collections.abc import Callable, Iterator
from pathlib import Path, PurePosixPath
from typing import Any

import pytest

from grader.checks.context import CheckContext, context_of
from grader.checks.nodes import NodeWatch, permissions_of, require_handed_in
from grader.checks.workspace import workspace_of
from grader.exercises import Exercise
from grader.submission import Submission
from simkit import Simulation
from simkit.graph.process import NodeRuntime

WATCH: pytest.StashKey[NodeWatch] = pytest.StashKey()


@pytest.fixture(scope="session")
def check_context(pytestconfig: pytest.Config) -> CheckContext:
    """What these checks are about."""
    return context_of(pytestconfig)


@pytest.fixture(scope="session")
def submission(check_context: CheckContext) -> Submission:
    """What the student handed in: `files` by path, `answers` by name."""
    return check_context.submission


@pytest.fixture(scope="session")
def exercise(check_context: CheckContext) -> Exercise:
    """What was asked for."""
    return check_context.exercise


@pytest.fixture(scope="session")
def package_path(pytestconfig: pytest.Config) -> Path:
    """Folder with the student's files, laid out as ROS packages."""
    return workspace_of(pytestconfig).package_path


@pytest.fixture(scope="session")
def node_runtime(pytestconfig: pytest.Config) -> NodeRuntime:
    """Where the student's nodes run: in the sandbox, under its limits."""
    return workspace_of(pytestconfig).runtime


@pytest.fixture
def seed(check_context: CheckContext, request: pytest.FixtureRequest) -> int:
    """A number that is the same at each run of a check, and another for each check."""
    text = f"{check_context.exercise.id}/{request.node.name}"
    return int.from_bytes(hashlib.sha256(text.encode()).digest()[:4], "big")


@pytest.fixture
def rng(seed: int) -> random.Random:
    """Random inputs for the check, the same at each run."""
    return random.Random(seed)


@pytest.fixture
def sim(
    seed: int, package_path: Path, node_runtime: NodeRuntime, request: pytest.FixtureRequest
) -> Iterator[Simulation]:
    """A fresh simulation that finds the student's package."""
    with Simulation(
        seed=seed, package_path=[str(package_path)], runtime=node_runtime, confined=True
    ) as simulation:
        request.node.stash[WATCH].simulation = simulation
        yield simulation


@pytest.fixture
def run_node(
    sim: Simulation, exercise: Exercise, submission: Submission, request: pytest.FixtureRequest
) -> Callable[..., Any]:
    """Start a script of the student: `run_node("listener.py", "_turtle:=turtle2")` is its node."""
    watch = request.node.stash[WATCH]
    permissions = permissions_of(exercise)

    def start(script: str, *arguments: str) -> Any:
        path = PurePosixPath(require_handed_in(script, exercise, submission))
        node = sim.rosrun(path.parts[0], path.name, *arguments, permissions=permissions)
        watch.nodes.append((path.name, node))
        return node

    return start


@pytest.fixture
def launch_plan(sim: Simulation, exercise: Exercise, submission: Submission) -> Callable[..., Any]:
    """What a launch file of the student comes to, without starting it: `launch_plan("x.launch").params`."""

    def plan(file: str, *arguments: str) -> Any:
        path = PurePosixPath(require_handed_in(file, exercise, submission))
        return sim.launch_plan(path.parts[0], "/".join(path.parts[1:]), *arguments)

    return plan


@pytest.fixture
def roslaunch(
    sim: Simulation,
    exercise: Exercise,
    launch_plan: Callable[..., Any],
    request: pytest.FixtureRequest,
) -> Callable[..., Any]:
    """Start a launch file of the student, or what `launch_plan` gave: `roslaunch("x.launch", "speed:=2")`."""
    watch = request.node.stash[WATCH]
    permissions = permissions_of(exercise)

    def start(file: Any, *arguments: str) -> Any:
        plan = launch_plan(file, *arguments) if isinstance(file, str) else file
        launch = sim.roslaunch(plan, permissions=permissions)
        watch.launches.append((PurePosixPath(plan.shown_file).name, launch))
        return launch

    return start
