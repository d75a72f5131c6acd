"""A rule on the plugin that publishes the positions of joints: which joints it lists."""

from __future__ import annotations

from collections.abc import Iterator

from simkit.diagnostics import Find, Severity, rule
from simkit.urdf.rules.joint_names import joint_advice, moving_joints
from simkit.urdf.rules.sheet import Sheet
from simkit.urdf.rules.values import shown
from simkit.urdf.rules.wording import listed, quoted
from simkit.xml import Element

_PLUGIN = "libgazebo_ros_joint_state_publisher.so"


@rule("CTL-W06", "a list of joints that does not fit the robot", Severity.ERROR)
def listed_joints(sheet: Sheet) -> Iterator[Find]:
    """The list of joints in `<jointName>` does not fit the robot.

    Symptom: `No transform from [lower_arm]` in RViz: a part of the robot hangs in the air. Or Gazebo ends with `Joint ...
    does not exist!`.

    Cause: A joint was added to the robot and not to the list, or its name is misspelt. The list is one line, with commas
    between the names; blanks do not matter, line breaks do.

    Remedy: All joints that move, in one `<jointName>`.

    Right:

        <jointName>hip, shoulder, elbow</jointName>
    """
    plugins = [plugin for plugin in sheet.plugins if plugin.filename == _PLUGIN]
    listed_names: set[str] = set()
    for plugin in plugins:
        for element in plugin.element.all("jointName"):
            yield from _wrong_names(sheet, element, listed_names)
    mimicking = {joint.name for joint in sheet.joints if joint.mimic_element is not None}
    unlisted = [
        joint.name
        for joint in sheet.joints
        if joint.moves and joint.name and joint.name not in listed_names | mimicking
    ]
    first = next((found for one in plugins if (found := one.parameter("jointName"))), None)
    if first is not None and unlisted:
        every = ", ".join(moving_joints(sheet))
        yield Find(
            first.text_span or first,
            severity=Severity.WARNING,
            element=first,
            what=f"the list of joints lacks {listed(unlisted)}",
            here="Nobody says where these joints are: the links below have no frame.",
            gazebo="Nobody says where these joints are: RViz shows no transform for the links below.",
            remedy=f"Write <jointName>{shown(every)}</jointName>.",
        )


def _wrong_names(sheet: Sheet, element: Element, listed_names: set[str]) -> Iterator[Find]:
    """What is wrong with the names in one list; the right ones are added to `listed_names`."""
    names = element.text.strip().replace(" ", "").split(",")
    moving = moving_joints(sheet)
    known = set(moving)
    one_line = shown(", ".join("".join(name.split()) for name in names))
    for name in names:
        bare = "".join(name.split())
        if bare in known:
            listed_names.add(bare)
            if bare == name:
                continue
            what = f"a line break or tab stands in the list of joints, next to {quoted(bare)}"
            remedy = f"Write the list in one line: {one_line}."
        elif not bare:
            what, remedy = "the list of joints has an empty name", "Leave out the needless comma."
        else:
            why = "which is fixed" if bare in sheet.joint_by_name else "and there is no such joint"
            what = f"the list of joints names {quoted(bare)}, {why}"
            remedy = joint_advice(sheet, bare, moving)
        yield Find(
            element.text_span or element,
            element=element,
            what=what,
            here="simkit refuses to start the plugin.",
            gazebo="Joint ... does not exist! The plugin then crashes Gazebo.",
            remedy=remedy,
        )
