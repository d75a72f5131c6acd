"""Puts the parameters of a launch file on the server."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from simkit.errors import UnknownNameError
from simkit.graph.params import ParameterServer
from simkit.graph.process import Permissions
from simkit.launch.plan import LaunchPlan, ParameterStep

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
