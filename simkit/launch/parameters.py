"""Parameters of a launch file: they go to the server; and robots among them, with the nodes that read one.

What `check_urdf` says of a robot stands here in short, and which node misses the description of one.
"""

from __future__ import annotations

import shlex
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from simkit.errors import UnknownNameError, near_names
from simkit.graph.params import ParameterServer
from simkit.launch.files import Budget, Files
from simkit.launch.plan import LaunchPlan, ParameterStep, PlannedNode
from simkit.launch.rules import DESCRIPTION
from simkit.packages import PackagePath

if TYPE_CHECKING:
    from simkit.graph.process import Permissions

PARAMETER = "robot_description"
_READERS = (
    "robot_state_publisher",
    "state_publisher",
    "joint_state_publisher",
    "joint_state_publisher_gui",
)
_WHO = "this launch file"


def apply_parameters(
    plan: LaunchPlan, params: ParameterServer, permissions: Permissions | None
) -> Iterator[str]:
    """Delete, dump, clear and set, in the order of roslaunch.

    Args:
        plan: The launch file.
        params: The parameter server.
        permissions: What may be written; anything if None.

    Yields:
        What there is to say of it; a line that begins with `refused: ` for what is not allowed.
    """
    for step in plan.steps:
        yield from _step(step, params, plan, permissions)
    for name in plan.clear_params:
        if refusal := _refusal(name, plan, permissions):
            yield refusal
        elif params.has(name):
            params.delete(name)
    for name, value in plan.params.items():
        if refusal := _refusal(name, plan, permissions):
            yield refusal
        else:
            params.set(name, value)


def _refusal(name: str, plan: LaunchPlan, permissions: Permissions | None) -> str | None:
    if permissions is None:
        return None
    nodes = [node.resolved_name for node in plan.nodes]
    sentence = permissions.refuse_parameter(name, *nodes, who=_WHO)
    return f"refused: {sentence}" if sentence else None


def _step(
    step: ParameterStep, params: ParameterServer, plan: LaunchPlan, permissions: Permissions | None
) -> Iterator[str]:
    if step.command == "dump":
        yield f"running rosparam dump {step.file or ''} {step.name}"
        yield from _dump(step, params)
        return
    yield f"running rosparam delete {step.name}"
    if refusal := _refusal(step.name, plan, permissions):
        yield refusal
        return
    try:
        params.delete(step.name)
    except UnknownNameError:
        yield f"ERROR: Parameter [{step.name}] is not set"


def _dump(step: ParameterStep, params: ParameterServer) -> Iterator[str]:
    from simkit.commands.parameter_yaml import dump_parameters

    value = params.get(step.name, None)
    if value is None:
        yield f"ERROR: Parameter [{step.name}] is not set"
    elif step.file is None:
        yield dump_parameters(value)
    else:
        Path(step.file).write_text(dump_parameters(value), encoding="utf-8")


def robot_lines(plan: LaunchPlan, packages: PackagePath, simulation: object) -> Iterator[str]:
    """One line for each error and warning of a robot, unless they were reported in the simulation already.

    Args:
        plan: The launch file.
        packages: Where meshes are.
        simulation: Whom they are reported to.
    """
    from simkit.urdf import read_robot
    from simkit.urdf.rules.check import brief_lines

    files = Files(packages, Budget())
    for name, value in plan.params.items():
        if name.rpartition("/")[2] != PARAMETER or not isinstance(value, str):
            continue
        source = plan.origins[name].source
        file = name if source is None else files.shown(source)
        reading = read_robot(value, file=file, packages=packages)
        if reading.is_first_report_to(simulation):
            yield from brief_lines(reading, is_file=source is not None)


def description_lines(plan: LaunchPlan, known: Sequence[str]) -> Iterator[str]:
    """A line for each node that needs a parameter which nobody has set, in any namespace.

    Args:
        plan: The launch file, its parameters set.
        known: Global names of all parameters that there are.
    """
    set_names = {name.rpartition("/")[2] for name in known}
    for node in plan.nodes:
        wanted = _wanted(node)
        if wanted is None or wanted in set_names:
            continue
        place = f"{node.shown_file}:{node.span.line}:{node.span.column}"
        near = near_names(wanted, set_names)
        remedy = f'Write <param name="{wanted}" textfile="..."/> into the launch file.'
        if near:
            remedy = f"Did you mean {' or '.join(near)}? The names must be the same."
        yield (
            f"{place}: warning [{DESCRIPTION}] the node {node.name} needs the parameter {wanted}, "
            f"and nobody has set it. {remedy}"
        )


def _wanted(node: PlannedNode) -> str | None:
    """Name of the parameter that a node reads its robot from, without namespaces; None if it reads none."""
    if node.type in _READERS:
        target = dict(node.remappings).get(PARAMETER, PARAMETER)
        return target.rpartition("/")[2]
    if node.type != "spawn_model":
        return None
    try:
        words = shlex.split(node.args)
    except ValueError:  # a quotation mark that is not closed: an error when the node starts
        return None
    if "-param" not in words[:-1]:
        return None
    return words[words.index("-param") + 1].rstrip("/").rpartition("/")[2]
