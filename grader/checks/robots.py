"""Robots that a student describes: what urdfdom makes of the file, and what is wrong with it."""

from __future__ import annotations

import itertools
from pathlib import Path
from typing import Any

from grader.checks.expect import expect_close, expect_equal
from grader.checks.nodes import require_handed_in
from grader.errors import CheckFailed
from grader.exercises import Exercise
from grader.submission import Submission
from simkit.diagnostics import Diagnostic, Severity
from simkit.packages import PackagePath
from simkit.urdf import Cylinder, Joint, Link, Reading, Robot, Visual, read_robot
from simkit.urdf.rules import check_robot
from simkit.xml import parse_xml


class RobotFiles:
    """The URDF files of one submission.

    Args:
        exercise: What was asked for.
        submission: What was handed in.
        package_path: Folder with the student's files, laid out as ROS packages.
    """

    def __init__(self, exercise: Exercise, submission: Submission, package_path: Path) -> None:
        self._exercise = exercise
        self._submission = submission
        self._packages = PackagePath([package_path], confined=True)

    def text(self, file: str) -> str:
        """The text of a file.

        Args:
            file: Its name, or its path as in the exercise.

        Raises:
            CheckFailed: It was not handed in.
        """
        return self._submission.files[self._path(file)]

    def robot(self, file: str) -> Robot:
        """The robot that a file describes.

        Raises:
            CheckFailed: It was not handed in, or ROS refuses it; says where and why.
        """
        reading = self._reading(file)
        if reading.robot is None:
            raise _refused(file, self._found(file), reading)
        return reading.robot

    def expect_clean(self, file: str, *, severity: Severity = Severity.WARNING) -> None:
        """Expect `simkit check_urdf` to have nothing to say but notes.

        Args:
            file: Its name, or its path as in the exercise.
            severity: The mildest that is a fault: WARNING, or ERROR.

        Raises:
            CheckFailed: It has; names the first thing, and how many more there are.
        """
        reading = self._reading(file)
        grave = (Severity.ERROR,) if severity is Severity.ERROR else (Severity.ERROR, severity)
        found = [one for one in self._found(file) if one.severity in grave]
        if reading.robot is None:
            raise _refused(file, found, reading)
        if found:
            raise _complaint(found)

    def _path(self, file: str) -> str:
        return require_handed_in(file, self._exercise, self._submission)

    def _reading(self, file: str) -> Reading:
        path = self._path(file)
        return read_robot(self._submission.files[path], file=path, packages=self._packages)

    def _found(self, file: str) -> tuple[Diagnostic, ...]:
        path = self._path(file)
        document = parse_xml(self._submission.files[path], file=path)
        return check_robot(document, packages=self._packages)


def link_of(robot: Robot, name: str) -> Link:
    """A link by name.

    Raises:
        CheckFailed: The robot has none of that name.
    """
    if name not in robot.links:
        raise CheckFailed(
            f"the robot has no link {name}",
            expected=f"a link named {name}",
            actual=", ".join(sorted(robot.links)) or "no link",
            hint="Every letter of a name counts, capitals too.",
        )
    return robot.links[name]


def only_visual(robot: Robot, link: str) -> Visual:
    """The one thing that is to be seen of a link.

    Raises:
        CheckFailed: There is nothing, or more than one.
    """
    visuals = _visuals_of(robot, link)
    if len(visuals) > 1:
        raise CheckFailed(f"{link} has {len(visuals)} visuals", hint="One <visual> is enough here.")
    return visuals[0]


def cylinder_of(robot: Robot, link: str) -> tuple[Visual, Cylinder]:
    """The one cylinder that is to be seen of a link; a mark or a knob of another shape may be beside it.

    Returns:
        The visual, and its shape.

    Raises:
        CheckFailed: There is none, or more than one.
    """
    visuals = _visuals_of(robot, link)
    found = [(one, one.geometry) for one in visuals if isinstance(one.geometry, Cylinder)]
    if not found:
        raise CheckFailed(
            f"{link} is a {type(visuals[0].geometry).__name__.lower()}, not a cylinder",
            hint="Write <cylinder length=... radius=.../> inside <geometry>.",
        )
    if len(found) > 1:
        raise CheckFailed(
            f"{link} is {len(found)} cylinders", hint="Keep only the one that the text asks for."
        )
    return found[0]


def expect_chain(robot: Robot, *links: str) -> None:
    """Expect each link to hang on the one before it, and the first one on nothing.

    Other links may lie in between, such as a footprint or a flange.

    Raises:
        CheckFailed: A link is missing, or hangs on another one.
    """
    expect_equal(
        robot.root,
        links[0],
        what="the root of the tree",
        hint="The root is the link that is not the child of any joint. Are parent and child swapped somewhere?",
    )
    for parent, link in itertools.pairwise(links):
        link_of(robot, link)
        holders = [joint.parent for joint in joints_above(robot, link)]
        expect_equal(
            parent if parent in holders else next(iter(holders), None),
            parent,
            what=f"the parent of {link}",
            hint="In a joint, <parent> is the link that holds, and <child> the link that is held.",
        )


def joints_above(robot: Robot, link: str) -> list[Joint]:
    """The joints from a link to the root, the nearest first; once around where they form a ring."""
    # The last one by name wins, as in Robot.joint_above; a table, for robots may be long.
    holding = {robot.joints[name].child: robot.joints[name] for name in sorted(robot.joints)}
    found: dict[str, Joint] = {}
    above = holding.get(link)
    while above is not None and above.name not in found:
        found[above.name] = above
        above = holding.get(above.parent)
    return list(found.values())


def expect_firm(robot: Robot, link: str) -> None:
    """Expect that no joint above a link can move.

    Raises:
        CheckFailed: One can.
    """
    for joint in joints_above(robot, link):
        if joint.moves:
            raise CheckFailed(
                f"{link} can move: the joint {joint.name} above it is {joint.type.value}",
                hint='A joint that holds its child for ever has type="fixed".',
            )


def expect_silver_cylinder(robot: Robot, link: str, *, length: float, radius: float) -> None:
    """Expect a link to be seen as one silver cylinder of a size [m].

    Raises:
        CheckFailed: It has another shape, size or colour.
    """
    visual, shape = cylinder_of(robot, link)
    expect_close(
        (shape.length, shape.radius),
        (length, radius),
        tolerance=1e-6,
        what=f"length and radius of {link}",
        unit="m",
        hint="The length runs along z, and the radius is half the width.",
    )
    expect_close(
        visual.material.rgba if visual.material else None,
        (0.75, 0.75, 0.75, 1.0),
        tolerance=0.01,
        what=f"the colour of {link}",
        hint='Once silver is defined, <material name="silver"/> is enough for the other links.',
    )


def slider_of(launched: Any) -> Any:
    """The program with the sliders among the nodes of a launch.

    Raises:
        CheckFailed: There is none.
    """
    for node in launched.nodes.values():
        program = getattr(node, "program", None)
        if hasattr(program, "set_position"):
            return program
    raise CheckFailed(
        "there is no slider",
        hint="joint_state_publisher shows sliders if the parameter use_gui is true: "
        '<param name="use_gui" value="true"/>.',
    )


def _visuals_of(robot: Robot, link: str) -> tuple[Visual, ...]:
    visuals = link_of(robot, link).visuals
    if not visuals:
        raise CheckFailed(
            f"{link} is invisible",
            hint="To be visible, a link needs a <visual> with a <geometry> in it.",
        )
    return visuals


def _refused(
    file: str, found: tuple[Diagnostic, ...] | list[Diagnostic], reading: Reading
) -> CheckFailed:
    errors = [one for one in found if one.severity is Severity.ERROR]
    if errors:
        return _complaint(errors)
    said = reading.messages[0] if reading.messages else "it gave no reason"
    return CheckFailed(f"check_urdf refuses {file}: {said}", hint="Run %check_urdf on it.")


def _complaint(found: list[Diagnostic]) -> CheckFailed:
    first = found[0]
    more = f" (and {len(found) - 1} more; %check_urdf shows them all)" if len(found) > 1 else ""
    place = f"{first.file}:{first.span.line}:{first.span.column}"
    return CheckFailed(f"{place}: {first.what}{more}", hint=first.remedy)
