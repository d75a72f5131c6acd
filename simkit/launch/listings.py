"""What the options of roslaunch print that start nothing: `--dump-params`, `--nodes`, `--args`, ...

Source: roslaunch `param_dump`, `node_args`, `arg_dump`.
"""

from __future__ import annotations

from simkit.errors import SimkitError, UnknownNameError, near_names
from simkit.launch.plan import LaunchPlan, PlannedNode
from simkit.launch.process import arguments_of
from simkit.packages import PackagePath


def params_text(plan: LaunchPlan) -> str:
    """`--dump-params`: the parameters as YAML."""
    from simkit.tools.parameter_yaml import dump_parameters

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
