"""The page of a robot's tree: heading, tree, key."""

from __future__ import annotations

from simkit.urdf.model import Joint, JointType, Limit, Mimic, Robot
from simkit.urdf.tree_text import axis_text, number_text, vector_text
from simkit.urdf.urdfdom.tree import children_by_link
from simkit.viz.draw.drawing import Drawing, Line, Point, Shape, Text
from simkit.viz.draw.letters import shortened, text_width
from simkit.viz.tree_drawing import GREY, INK, PAPER, tree_shapes
from simkit.viz.tree_layout import LONGEST, CardNode, tree_layout

_MARGIN = 18.0
_READABLE_WIDTH = 1000.0
"Up to this width a page of a notebook shows a tree that grows downwards."
_SMALL = 12.5
_TITLE = 15.0
_TOP = 62.0
_FIXED = "broken line: a fixed joint"


def draw_robot_tree(robot: Robot) -> Drawing:
    """The page for a robot."""
    nodes = robot_nodes(robot)
    layout = tree_layout(nodes, is_sideways=False)
    if layout.size[0] > _READABLE_WIDTH:
        layout = tree_layout(nodes, is_sideways=True)
    heading = _heading(robot)
    width = max(
        layout.size[0], *(_width(line) for line in heading), text_width(_FIXED, _SMALL) + 60
    )
    bottom = _TOP + layout.size[1]
    shapes: list[Shape] = [
        *heading,
        *tree_shapes(layout, ((width + 2 * _MARGIN - layout.size[0]) / 2, _TOP)),
    ]
    if any(node.is_dashed for node in nodes):
        shapes += _key((_MARGIN, bottom + 8))
        bottom += 10
    return Drawing(
        title=f"Links and joints of {robot.name}",
        description=" ".join(_sentence(robot.joints[name]) for name in sorted(robot.joints))
        or f"One link: {robot.root}.",
        size=(round(width + 2 * _MARGIN), round(bottom + _MARGIN)),
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


def _heading(robot: Robot) -> list[Text]:
    links, joints = len(robot.links), len(robot.joints)
    moving = sum(joint.moves for joint in robot.joints.values())
    counted = (
        f"{links} link{'s' * (links != 1)}, {joints} joint{'s' * (joints != 1)} "
        f"({moving or 'none'} move{'s' * (moving < 2)})"
    )
    title = shortened(robot.name, LONGEST) or "a robot without a name"
    return [
        Text(place=(_MARGIN, 30), text=title, color=INK, size=_TITLE, bold=True),
        Text(place=(_MARGIN, 50), text=counted, color=GREY, size=_SMALL),
    ]


def _width(line: Text) -> float:
    return text_width(line.text, line.size) * (1.15 if line.bold else 1.0)


def _key(place: Point) -> list[Shape]:
    x, y = place
    return [
        Line(points=((x, y - 4), (x + 32, y - 4)), color=GREY, width=1.6, dashed=True),
        Text(place=(x + 42, y), text=_FIXED, color=GREY, size=_SMALL - 1),
    ]


def _sentence(joint: Joint) -> str:
    return f"{joint.child} hangs on {joint.parent} by {joint.name} ({joint.type.value})."
