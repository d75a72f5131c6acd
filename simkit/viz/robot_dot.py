"""The tree of a robot for graphviz, in the form of urdfdom's urdf_to_graphviz."""

from __future__ import annotations

from simkit.urdf.model import Joint, Robot
from simkit.urdf.tree_text import vector_text


def robot_dot_text(robot: Robot) -> str:
    r"""The tree as a digraph: boxes for links, ellipses for joints; the `\n` in the labels are graphviz' own.

    Source:
        urdf_to_graphviz of urdfdom 3.0, which quotes nothing in names, and writes -0 for many a 0.
    """
    links = [f"{_quoted(name)} [label={_quoted(name)}];" for name in sorted(robot.links)]
    joints = [line for name in sorted(robot.joints) for line in _edges(robot.joints[name])]
    return "\n".join(
        [
            "digraph G {",
            "node [shape=box];",
            *links,
            "node [shape=ellipse, color=blue, fontcolor=blue];",
            *joints,
            "}\n",
        ]
    )


def _edges(joint: Joint) -> tuple[str, str]:
    xyz, rpy = vector_text(joint.origin.xyz), vector_text(joint.origin.rpy)
    name = _quoted(joint.name)
    return (
        f'{_quoted(joint.parent)} -> {name} [label="xyz: {xyz} \\nrpy: {rpy}"]',
        f"{name} -> {_quoted(joint.child)}",
    )


def _quoted(name: str) -> str:
    escaped = name.replace("\\", "\\\\").replace('"', '\\"')
    return f'"{escaped}"'
