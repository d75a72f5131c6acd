"""Launch files, mutated: each gives a plan or one clear error, soon, and nothing is kept."""

import faulthandler
import random
import sys
import time
from pathlib import Path

import pytest

from simkit.diagnostics import as_text
from simkit.errors import SimkitError
from simkit.launch import LaunchError, evaluate, summary_of
from simkit.packages import PackagePath

SEED_FILE = """<?xml version="1.0"?>
<launch>
  <arg name="model" default="$(find play)/r.urdf" doc="the robot"/>
  <arg name="gui" default="true"/> <arg name="n" value="$(eval 2 * 3 + len('ab'))"/>
  <param name="robot_description" textfile="$(arg model)"/>
  <param name="use_gui" value="$(arg gui)"/> <param name="~rate" type="double" value="10"/>
  <rosparam file="$(find play)/c.yaml" command="load" ns="arm"/>
  <rosparam param="angles">[deg(90), rad(pi/2), {a: 1, b: [x, 'y']}]</rosparam>
  <remap from="joint_states" to="/robot/joint_states"/>
  <group ns="one" if="$(arg gui)">
    <node name="$(anon jsp)" pkg="joint_state_publisher" type="joint_state_publisher"/>
    <node name="rsp" pkg="robot_state_publisher" type="robot_state_publisher" output="screen"
      respawn="true" respawn_delay="1.5" args="_x:=1 'a b'"><param name="f" command="cat $(arg model)"/></node>
  </group>
  <include file="$(dirname)/inner.launch" ns="two" pass_all_args="false"><arg name="v" value="$(arg n)"/></include>
  <!-- a comment --> <env name="A" value="$(optenv HOME none)"/>
</launch>
"""
INNER = '<launch><arg name="v"/><param name="v" value="$(arg v)"/></launch>'
PIECES = [
    "<", ">", "/>", "</launch>", "<launch>", '"', "'", "&amp;", "&", "&x;", "$(", ")", "$(arg x)",
    "$(eval ", "$(find play)", "--", "<!--", "]]>", "<![CDATA[", "\0", "\n", "\t", " ", "=", "if=",
    'if="1"', "<group>", "</group>", "<node/>", "<!DOCTYPE a [<!ENTITY b 'c'>]>", "*a", "&a ", "é",
    "\ufeff", "{", "}", "[", ": ", "- ", "1e999", "9" * 30, "true", "..", "/etc/passwd", "~", "//",
]  # fmt: skip


def mutated(rng, text):
    for _ in range(rng.choice((1, 1, 1, 2, 4))):
        at, length = rng.randrange(len(text) + 1), rng.randint(0, 12)
        match rng.randrange(4):
            case 0:
                text = text[:at] + text[at + length :]
            case 1:
                text = text[:at] + rng.choice(PIECES) + text[at:]
            case 2:
                text = text[:at] + rng.choice(PIECES) + text[at + length :]
            case _:
                other = rng.randrange(len(text) + 1)
                text = text[:at] + text[other : other + rng.randint(0, 80)] + text[at:]
    return text


def evaluate_many(write, package, count):
    write("r.urdf", "<robot name='r'><link name='a'/></robot>")
    write("inner.launch", INNER)
    seed_yaml = "gain: 1.5\njoints: [hip, shoulder]\nname: &a elbow\nagain: *a\n"
    packages = PackagePath([package.folder], confined=True)
    rng = random.Random(17)
    plans = errors = 0
    for _ in range(count):
        write("c.yaml", mutated(rng, seed_yaml) if rng.random() < 0.3 else seed_yaml)
        (write.folder / "a.launch").write_bytes(
            mutated(rng, SEED_FILE).encode("utf-8", "surrogatepass")
        )
        start = time.process_time()
        try:
            evaluate(write.folder / "a.launch", packages=packages, arguments={"gui": "false"})
            plans += 1
        except LaunchError as error:
            errors += bool(error.remedy and str(error))
        assert time.process_time() - start < 3.0
    return plans, errors


def test_some_mutations(write, package):
    plans, errors = evaluate_many(write, package, 150)
    assert plans > 10
    assert plans + errors == 150


@pytest.mark.slow
def test_thousands_of_mutations_leave_no_trace(write, package):
    resource = pytest.importorskip("resource", reason="memory is measured on Linux and macOS")
    unit = 1024 if sys.platform != "darwin" else 1
    evaluate_many(write, package, 500)
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * unit
    plans, errors = evaluate_many(write, package, 2000)
    grown = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * unit - before
    assert plans > 150
    assert plans + errors == 2000
    assert grown < 30_000_000


ROBOTS = Path(__file__).resolve().parents[3] / "robots"
STUCK = 120.0
"""Seconds after which a file counts as never-ending: the test run is ended, with a traceback."""


def spoil_the_book(write, mutated, seed, count):
    """Evaluates the launch files of the book, spoiled; gives the numbers of plans and of errors."""
    rng = random.Random(seed)
    texts = [path.read_text() for path in sorted(ROBOTS.rglob("*.launch"))]
    packages = PackagePath([write.folder.parent, ROBOTS], confined=True)
    plans = errors = 0
    for _ in range(count):
        data = mutated(rng.choice([*texts, SEED_FILE]), rng)
        path = write.folder / "spoiled.launch"  # stays there if the evaluation fails
        path.write_bytes(data)
        faulthandler.dump_traceback_later(STUCK, exit=True, file=sys.__stderr__)
        try:
            plan = evaluate(path, packages=packages, environment={})
            plans += 1
            assert as_text(plan.diagnostics) or not plan.diagnostics
            assert summary_of(plan)
        except SimkitError as error:
            errors += bool(str(error).strip())
        finally:
            faulthandler.cancel_dump_traceback_later()
    return plans, errors


def test_some_spoiled_files_of_the_book(write, mutated):
    plans, errors = spoil_the_book(write, mutated, 1, 60)
    assert plans > 5
    assert plans + errors == 60


@pytest.mark.slow
def test_thousands_of_spoiled_files_of_the_book(write, mutated):
    plans, errors = spoil_the_book(write, mutated, 2, 6000)
    assert plans > 500
    assert plans + errors == 6000
