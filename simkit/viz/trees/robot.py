"""The tree of a robot as a picture and for graphviz: a box for each link, on the line to its parent the joint."""

from __future__ import annotations

from simkit.urdf.model import Joint, JointType, Limit, Mimic, Robot
from simkit.urdf.tree_text import axis_text, number_text, vector_text
from simkit.urdf.urdfdom.tree import children_by_link
from simkit.viz.draw.drawing import Drawing, Label, Shape
from simkit.viz.draw.letters import abbreviated, text_width
from simkit.viz.trees.drawing import (
    GREY,
    INK,
    MARGIN,
    PAPER,
    READABLE_WIDTH,
    SMALL,
    TreePicture,
    dot_quoted,
    key_of_broken_lines,
    tree_shapes,
)
from simkit.viz.trees.layout import LONGEST, CardNode, tree_layout

_TITLE = 15.0
_TOP = 62.0
_FIXED = "broken line: a fixed joint"


class RobotTree(TreePicture):
    """What `urdf_to_graphviz` draws of a URDF: links, joints, and where each joint is.

    Args:
        robot: The robot.

    Source:
        urdf_to_graphviz of urdfdom has the names and origins; type, axis and limits are ours, and so is the layout.
    """

    def __init__(self, robot: Robot) -> None:
        self._robot = robot

    def to_dot(self) -> str:
        """The tree in graphviz' language, as urdf_to_graphviz writes it."""
        return _robot_dot_text(self._robot)

    def __repr__(self) -> str:
        robot = self._robot
        return f"RobotTree({robot.name}: {len(robot.links)} links, {len(robot.joints)} joints)"

    def drawing(self) -> Drawing:
        """Links and joints."""
        return _draw_robot_tree(self._robot)


def _draw_robot_tree(robot: Robot) -> Drawing:
    """The page for a robot."""
    nodes = robot_nodes(robot)
    layout = tree_layout(nodes, is_sideways=False)
    if layout.size[0] > READABLE_WIDTH:
        layout = tree_layout(nodes, is_sideways=True)
    heading = _heading(robot)
    width = max(layout.size[0], *(_width(line) for line in heading), text_width(_FIXED, SMALL) + 60)
    bottom = _TOP + layout.size[1]
    shapes: list[Shape] = [
        *heading,
        *tree_shapes(layout, ((width + 2 * MARGIN - layout.size[0]) / 2, _TOP)),
    ]
    if any(node.is_dashed for node in nodes):
        shapes += key_of_broken_lines((MARGIN, bottom + 8), _FIXED)
        bottom += 10
    return Drawing(
        title=f"Links and joints of {robot.name}",
        description=" ".join(_sentence(robot.joints[name]) for name in sorted(robot.joints))
        or f"One link: {robot.root}.",
        size=(round(width + 2 * MARGIN), round(bottom + MARGIN)),
        background=PAPER,
        shapes=tuple(shapes),
    )


def robot_nodes(robot: Robot) -> list[CardNode]:
    """The tree with the facts of each joint; a link that hangs on several is an echo below the others."""
    below = children_by_link(robot.joints)
    nodes = [CardNode(name=robot.root, parent=None)]
    seen = {robot.root}
    waiting = [(0, joint) for joint in reversed(below.get(robot.root, []))]
    while waiting:
        parent, joint = waiting.pop()
        is_echo = joint.child in seen
        seen.add(joint.child)
        is_fixed = joint.type is JointType.FIXED
        nodes.append(
            CardNode(
                name=joint.child,
                parent=parent,
                facts=joint_facts(joint),
                is_dashed=is_fixed,
                is_echo=is_echo,
            )
        )
        if not is_echo:
            number = len(nodes) - 1
            waiting += [(number, other) for other in reversed(below.get(joint.child, []))]
    return nodes


def joint_facts(joint: Joint) -> tuple[tuple[str, str], ...]:
    """What is worth knowing of a joint, with names: those of the tags and attributes of URDF."""
    facts = [("joint", joint.name), ("type", joint.type.value)]
    if joint.moves:
        facts.append(("axis", axis_text(joint.axis)))
    facts.append(("xyz", f"{vector_text(joint.origin.xyz)} m"))
    if any(joint.origin.rpy):
        facts.append(("rpy", f"{vector_text(joint.origin.rpy)} rad"))
    if joint.limit is not None and joint.type in (JointType.REVOLUTE, JointType.PRISMATIC):
        facts.append(("limit", _limit_text(joint.limit, joint.type)))
    if joint.mimic is not None:
        facts.append(("mimic", _mimic_text(joint.mimic)))
    return tuple(facts)


def _limit_text(limit: Limit, type_: JointType) -> str:
    unit = "m" if type_ is JointType.PRISMATIC else "rad"
    return f"{number_text(limit.lower)} to {number_text(limit.upper)} {unit}"


def _mimic_text(mimic: Mimic) -> str:
    text = (
        f"{number_text(mimic.multiplier)} * {mimic.joint}" if mimic.multiplier != 1 else mimic.joint
    )
    if not mimic.offset:
        return text
    sign = "-" if mimic.offset < 0 else "+"
    return f"{text} {sign} {number_text(abs(mimic.offset))}"


def _heading(robot: Robot) -> list[Label]:
    links, joints = len(robot.links), len(robot.joints)
    moving = sum(joint.moves for joint in robot.joints.values())
    counted = (
        f"{links} link{'s' * (links != 1)}, {joints} joint{'s' * (joints != 1)} "
        f"({moving or 'none'} move{'s' * (moving < 2)})"
    )
    title = abbreviated(robot.name, LONGEST) or "a robot without a name"
    return [
        Label(place=(MARGIN, 30), text=title, color=INK, size=_TITLE, bold=True),
        Label(place=(MARGIN, 50), text=counted, color=GREY, size=SMALL),
    ]


def _width(line: Label) -> float:
    return text_width(line.text, line.size) * (1.15 if line.bold else 1.0)


def _sentence(joint: Joint) -> str:
    return f"{joint.child} hangs on {joint.parent} by {joint.name} ({joint.type.value})."


def _robot_dot_text(robot: Robot) -> str:
    r"""The tree as a digraph: boxes for links, ellipses for joints; the `\n` in the labels are graphviz' own.

    Source:
        urdf_to_graphviz of urdfdom 3.0, which quotes nothing in names, and writes -0 for many a 0.
    """
    links = [f"{dot_quoted(name)} [label={dot_quoted(name)}];" for name in sorted(robot.links)]
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
    name = dot_quoted(joint.name)
    return (
        f'{dot_quoted(joint.parent)} -> {name} [label="xyz: {xyz} \\nrpy: {rpy}"]',
        f"{name} -> {dot_quoted(joint.child)}",
    )
