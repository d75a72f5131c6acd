"""What roslaunch prints of a launch file: its summary and warnings before anything starts, and lists (`--nodes`, ...).

Source: roslaunch `ROSLaunchConfig.summary` (sorted lines, long values cut, nodes by namespace), `param_dump`,
`node_args`, `arg_dump`.
"""

from __future__ import annotations

import argparse
from typing import Any

from simkit.diagnostics import Severity
from simkit.errors import SimkitError, UnknownNameError, near_names
from simkit.launch.plan import LaunchPlan, PlannedNode
from simkit.launch.process import arguments_of
from simkit.packages import PackagePath

_LONGEST = 20


def summary_of(plan: LaunchPlan) -> str:
    """Parameters and nodes of a launch file, as roslaunch lists them."""
    text = "SUMMARY\n========"
    if plan.clear_params:
        text += "\n\nCLEAR PARAMETERS\n" + _lines(f" * {name}" for name in plan.clear_params)
    if plan.params:
        values = (f" * {name}: {_short(value)}" for name, value in plan.params.items())
        text += "\n\nPARAMETERS\n" + _lines(values)
    text += "\n\nNODES\n"
    by_namespace: dict[str, list[str]] = {}
    for node in plan.nodes:
        line = f"    {node.name} ({node.package}/{node.type})"
        by_namespace.setdefault(node.namespace, []).append(line)
    for namespace, nodes in by_namespace.items():
        text += f"  {namespace}\n{_lines(nodes)}\n"
    return text


def _lines(lines: Any) -> str:
    return "\n".join(sorted(lines))


def _short(value: Any) -> str:
    text = str(value)
    if len(text) > _LONGEST:
        text = text[: _LONGEST - 3] + "..."
    return text if all(32 <= ord(letter) <= 126 for letter in text) else "<...>"


def warning_lines(plan: LaunchPlan) -> list[str]:
    """What roslaunch warns of in a launch file, and the place and remedy of each."""
    return [
        *plan.warnings,
        *(
            f"{one.file}:{one.span.line}:{one.span.column}: {one.severity.value} [{one.rule}] "
            f"{one.what}. {one.remedy}"
            for one in plan.diagnostics
            if one.severity is not Severity.NOTE
        ),
    ]


def add_list_options(parser: argparse.ArgumentParser) -> None:
    """`--dump-params`, `--nodes` and their kin."""
    lists = parser.add_argument_group("to list instead")
    lists.add_argument("--dump-params", action="store_true", help="the parameters, as YAML")
    lists.add_argument("--nodes", action="store_true", help="the names of the nodes")
    lists.add_argument("--files", action="store_true", help="the launch files that are read")
    lists.add_argument("--ros-args", action="store_true", help="the arguments of the file")
    lists.add_argument("--args", dest="node_args", metavar="NODE", help="command line of a node")
    lists.add_argument("--find-node", metavar="NODE", help="the launch file that a node is in")


def wants_list(options: argparse.Namespace) -> bool:
    """Whether one of these options is given."""
    names = ("dump_params", "nodes", "files", "ros_args", "node_args", "find_node")
    return any(getattr(options, name) for name in names)


def list_text(plan: LaunchPlan, options: argparse.Namespace, packages: PackagePath) -> str:
    """What the option prints; of several the first one counts.

    Args:
        plan: The launch file.
        options: The options that are given.
        packages: Where packages are.

    Raises:
        SimkitError: A node is asked for that is not there.
    """
    if options.dump_params:
        return params_text(plan)
    if options.nodes:
        return nodes_text(plan)
    if options.files:
        return files_text(plan)
    if options.ros_args:
        return arguments_text(plan)
    if options.find_node:
        return file_of_node_text(plan, options.find_node)
    return command_of_node_text(plan, options.node_args, packages)


def params_text(plan: LaunchPlan) -> str:
    """`--dump-params`: the parameters as YAML."""
    from simkit.commands.parameter_yaml import dump_parameters

    return dump_parameters(dict(plan.params)) + "\n"


def nodes_text(plan: LaunchPlan) -> str:
    """`--nodes`: the names of the nodes."""
    return "\n".join(node.resolved_name for node in plan.nodes) + "\n"


def files_text(plan: LaunchPlan) -> str:
    """`--files`: the launch files that are read."""
    return "\n".join(dict.fromkeys(plan.files)) + "\n"


def file_of_node_text(plan: LaunchPlan, name: str) -> str:
    """`--find-node NAME`: the launch file that a node is in.

    Raises:
        SimkitError: There is no such node.
    """
    return f"{_find_node(plan, name).file}\n"


def command_of_node_text(plan: LaunchPlan, name: str, packages: PackagePath) -> str:
    """`--args NAME`: the command line that starts a node.

    Raises:
        SimkitError: There is no such node, or its program is not there.
    """
    node = _find_node(plan, name)
    words = [f"{key}={value}" for key, value in node.environment]
    if node.namespace != "/":
        words.insert(0, f"ROS_NAMESPACE={node.namespace.rstrip('/')}")
    try:
        program = str(packages.find(node.package).find_executable(node.type))
    except UnknownNameError:
        program = f"{node.package}/{node.type}"
    arguments = [word for word in arguments_of(node) if not word.startswith("__ns:=")]
    return " ".join([*words, program, *arguments]) + "\n"


def arguments_text(plan: LaunchPlan) -> str:
    """`--ros-args`: the arguments of the file."""
    if not plan.arguments:
        return "No arguments.\n"
    arguments = sorted(plan.arguments, key=lambda one: one.name)
    required = [
        f"  {one.name}: {one.doc or 'undocumented'}" for one in arguments if one.default is None
    ]
    optional = [
        f'  {one.name} (default "{one.default}"): {one.doc or "undocumented"}'
        for one in arguments
        if one.default is not None
    ]
    lines = ["Required Arguments:", *required] if required else []
    lines += ["Optional Arguments:", *optional] if optional else []
    return "\n".join(lines) + "\n"


def _find_node(plan: LaunchPlan, name: str) -> PlannedNode:
    wanted = name if name.startswith("/") else f"/{name}"
    for node in plan.nodes:
        if node.resolved_name == wanted:
            return node
    known = [node.resolved_name for node in plan.nodes]
    listed = "\n".join(f" * {one}" for one in known)
    near = near_names(wanted, known)
    hint = f"\ndid you mean {near[0]}?" if near else ""
    raise SimkitError(
        f"ERROR: Cannot find node named [{wanted}] in [{plan.file}].\nNode names are:\n{listed}{hint}"
    )
