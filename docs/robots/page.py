"""The part of robots/README.md that is computed: a section for each robot."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from facts import RobotFacts

from simkit.diagnostics import Severity, count_text
from simkit.urdf import Box, Collision, Cylinder, Joint, Link, Sphere, Visual
from simkit.urdf.tree_text import motion_text, number_text, pose_text

Row = Sequence[str]


def section(facts: RobotFacts, positions: Mapping[str, float]) -> str:
    """What there is to know of a robot, as Markdown.

    Args:
        facts: The robot.
        positions: Where its joints are in the picture, by name [rad].
    """
    links = [_link_row(link) for link in facts.robot.links.values()]
    joints = [_joint_row(joint) for joint in facts.robot.joints.values()]
    return "\n".join(
        [
            f"#### {facts.path.name}\n",
            f"{facts.purpose}\n",
            _pictures(facts, positions),
            _table(("", "with all joints at 0"), _fact_rows(facts)),
            _table(("link", "shapes [m]", "mass [kg]", "centre of mass [m]"), links),
            _table(("joint", "motion", "parent", "child", "place [m, rad]", "limits"), joints),
        ]
    )


def _pictures(facts: RobotFacts, positions: Mapping[str, float]) -> str:
    name = facts.path.name
    images = (
        f"![{name} in 3D](pictures/{facts.stem}.png)",
        f"![links and joints of {name}](pictures/{facts.stem}_tree.svg)",
    )
    stands = ", ".join(f"{joint} at {number_text(where)} rad" for joint, where in positions.items())
    return _table((stands or "all joints at 0", "links and joints"), [images])


def _fact_rows(facts: RobotFacts) -> Iterable[Row]:
    root = f"`{facts.robot.root}`"
    if facts.mass:
        yield "mass", f"{_rounded(facts.mass)} kg"
        yield "centre of mass", f"{_triple(facts.centre)} m in {root}"
    else:
        yield "mass", "none: a robot to look at"
    size = [high - low for low, high in zip(facts.low, facts.high, strict=True)]
    yield "size", f"{' x '.join(map(_rounded, size))} m"
    yield "reaches", f"from {_triple(facts.low)} to {_triple(facts.high)} m in {root}"
    yield "`check_urdf` prints", f"<pre>{_lines(facts.printed)}</pre>"
    yield "`check_urdf` finds", _finds(facts)


def _finds(facts: RobotFacts) -> str:
    worse = [one for one in facts.finds if one.severity is not Severity.NOTE]
    if worse:
        raise SystemExit(f"{facts.path}: check_urdf finds {count_text(worse)}")
    notes = "; ".join(f"{one.rule}, {one.what}" for one in facts.finds)
    return "no errors, no warnings" + (f"; to be known: {notes}" if notes else "")


def _lines(printed: str) -> str:
    return printed.rstrip("\n").replace("\n", "<br>")


def _link_row(link: Link) -> Row:
    shapes = list(dict.fromkeys(map(_shape_text, (*link.visuals, *link.collisions))))
    inertial = link.inertial
    if inertial is None:
        return f"`{link.name}`", "; ".join(shapes) or "none", "none", ""
    mass, centre = number_text(inertial.mass), _triple(inertial.origin.xyz)
    return f"`{link.name}`", "; ".join(shapes) or "none", mass, centre


def _shape_text(part: Visual | Collision) -> str:
    match part.geometry:
        case Box(size):
            return f"box {' x '.join(map(number_text, size))}"
        case Cylinder(radius, length):
            return f"cylinder, radius {number_text(radius)}, length {number_text(length)}"
        case Sphere(radius):
            return f"sphere, radius {number_text(radius)}"
    return f"mesh {part.geometry.filename}"


def _joint_row(joint: Joint) -> Row:
    limit = joint.limit
    limits = "none" if joint.moves else ""
    if limit is not None:
        limits = f"{number_text(limit.effort)} N m, {number_text(limit.velocity)} rad/s"
    place = pose_text(joint.origin) or "that of its parent"
    ends = f"`{joint.parent}`", f"`{joint.child}`"
    return f"`{joint.name}`", motion_text(joint), *ends, place, limits


def _triple(vector: Sequence[float]) -> str:
    return f"({', '.join(map(_rounded, vector))})"


def _rounded(value: float) -> str:
    return number_text(round(value, 4))


def _table(head: Row, rows: Iterable[Row]) -> str:
    lines = [head, ["---"] * len(head), *rows]
    return "".join(f"| {' | '.join(line)} |\n" for line in lines)
