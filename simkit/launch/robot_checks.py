"""Robots of a launch file: what `check_urdf` says of them in short, and nodes that miss the description of one."""

from __future__ import annotations

import shlex
from collections.abc import Iterator, Sequence

from simkit.errors import near_names
from simkit.launch.budget import Budget
from simkit.launch.files import Files
from simkit.launch.plan import LaunchPlan, PlannedNode
from simkit.launch.rules import DESCRIPTION
from simkit.packages import PackagePath

PARAMETER = "robot_description"


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


_READERS = (
    "robot_state_publisher",
    "state_publisher",
    "joint_state_publisher",
    "joint_state_publisher_gui",
)


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
    except ValueError:  # a quotation mark that is not closed: told when the node starts
        return None
    if "-param" not in words[:-1]:
        return None
    return words[words.index("-param") + 1].rstrip("/").rpartition("/")[2]
