"""Rules on who moves joints, and who says where they are: transmissions and their plugin, and the list of joints to publish."""

from __future__ import annotations

from collections.abc import Iterator

from simkit.diagnostics import Find, Part, Severity, rule
from simkit.plugins.control.registry import INTERFACES, POSITION, PREFIX
from simkit.urdf.rules.entries import TransmissionEntry
from simkit.urdf.rules.plugin_joints import joint_advice, moving_joints
from simkit.urdf.rules.sheet import Sheet
from simkit.urdf.rules.vocabulary import nearest
from simkit.urdf.rules.wording import listed, meant, quoted, shown
from simkit.xml import Element

CONTROL = "libgazebo_ros_control.so"
"""The plugin that reads transmissions."""

_READ_ONLY = ("JointStateInterface", "ImuSensorInterface", "ForceTorqueSensorInterface")
"Interfaces of ros_control that Gazebo's plugin does not offer for a joint."
_SIMPLE = "transmission_interface/SimpleTransmission"
_KINDS = ("SimpleTransmission", "DifferentialTransmission", "FourBarLinkageTransmission")
_SKIPPED = "gazebo_ros_control skips the transmission: the joint cannot be controlled."


@rule("CTL-E01", "transmission, controller and type that do not fit", Severity.ERROR)
def three_places(sheet: Sheet) -> Iterator[Find]:
    """The transmission, the controller and its type do not fit together.

    Symptom: `Could not find joint 'hip' in 'hardware_interface::PositionJointInterface'`, `No valid hardware interface
    element found`, and the controller does not start.

    Cause: Three places must agree. The `<transmission>` names a joint of the robot and a hardware interface, inside of its
    `<joint>`. The YAML file names the joints that a controller moves. And the type of the controller says which interface
    it needs: `position_controllers/...` needs `PositionJointInterface`, and likewise for velocity and effort.

    Remedy: The same joint, with the same interface, in all three.

    Right:

        <transmission name="tran0">
          <type>transmission_interface/SimpleTransmission</type>
          <joint name="hip">
            <hardwareInterface>hardware_interface/PositionJointInterface</hardwareInterface>
          </joint>
          <actuator name="motor0"><mechanicalReduction>1</mechanicalReduction></actuator>
        </transmission>

        arm_controller:
          type: position_controllers/JointTrajectoryController
          joints: [hip]
    """
    moving, bad = moving_joints(sheet), _severity(sheet)
    for transmission in sheet.transmissions:
        yield from _part_faults(transmission, bad)
        for joint in transmission.joints:
            yield from _joint_faults(sheet, joint, moving, bad)
            yield from _interface_faults(transmission, joint, bad)
    if sheet.companions:
        from simkit.urdf.rules.controllers import controller_faults  # most calls have no YAML

        yield from controller_faults(sheet, offered_interfaces(sheet))


@rule("CTL-E02", "transmissions, but no plugin that reads them", Severity.WARNING)
def control_plugin(sheet: Sheet) -> Iterator[Find]:
    """Transmissions, but nothing in the simulation that reads them.

    Symptom: `Controller Spawner couldn't find the expected controller_manager ROS interface`.

    Cause: The controller manager lives in the plugin `libgazebo_ros_control.so`, and the URDF does not load it.

    Remedy: Add it, once, in a `<gazebo>` without reference.

    Right:

        <gazebo>
          <plugin name="control" filename="libgazebo_ros_control.so"/>
        </gazebo>
    """
    plugins = [plugin for plugin in sheet.plugins if plugin.filename and "ros_control" in plugin.filename]  # fmt: skip
    if sheet.transmissions and not plugins:
        first = sheet.transmissions[0].element
        yield Find(
            first,
            severity=Severity.WARNING if sheet.gazebo or sheet.companions else Severity.NOTE,
            what=f"{len(sheet.transmissions)} transmission{'s' if len(sheet.transmissions) > 1 else ''}, and no plugin {CONTROL}",
            here="No controller manager is started: the joints cannot be commanded.",
            gazebo="No controller manager is started: the spawner waits, and gives up.",
            remedy=f'Add <gazebo><plugin name="control" filename="{CONTROL}"/></gazebo>.',
        )
    elif plugins and not sheet.transmissions and moving_joints(sheet):
        yield Find(
            plugins[0].element,
            what=f"the plugin {CONTROL}, and no <transmission> that says which joints it may move",
            both="The controller manager starts and has no joints.",
            remedy=f"Add a <transmission> for each joint that is to be controlled: {listed(moving_joints(sheet))}.",
        )


def offered_interfaces(sheet: Sheet) -> dict[str, str | None]:
    """The first interface of each joint in the transmissions, without prefix; None if it has none."""
    found: dict[str, str | None] = {}
    for transmission in sheet.transmissions:
        for joint in transmission.joints:
            name, element = joint.get("name"), joint.child("hardwareInterface")
            text = None if element is None else element.text.strip().removeprefix(PREFIX)
            if name:
                found.setdefault(name, text)
    return found


def _severity(sheet: Sheet) -> Severity:
    """Errors only where something in these files reads the transmissions; they may be for a real robot."""
    is_read = sheet.companions or any(
        "ros_control" in (one.filename or "") for one in sheet.plugins
    )
    return Severity.ERROR if is_read else Severity.WARNING


def _part_faults(entry: TransmissionEntry, bad: Severity) -> Iterator[Find]:
    missing = []
    if not entry.name:
        missing.append('the attribute name="..."')
    if not entry.type:
        missing.append(f"<type>{_SIMPLE}</type>")
    if not entry.joints:
        missing.append('<joint name="..."> with a <hardwareInterface>')
    if not entry.actuators:
        missing.append('<actuator name="...">')
    if missing:
        yield Find(
            entry.element,
            severity=bad,
            what=f"the transmission {quoted(entry.name)} lacks {' and '.join(missing)}",
            here=_SKIPPED.replace("gazebo_ros_control", "simkit"),
            gazebo=_SKIPPED,
            remedy=f"Add {' and '.join(missing)}.",
        )
    kind = entry.type or _SIMPLE
    name = kind.rpartition("/")[2]
    if name not in _KINDS and nearest(name, _KINDS) is not None:
        element = entry.element.child("type") or entry.element
        yield Find(
            Part(element),
            severity=Severity.NOTE,
            what=f"there is no transmission of type {quoted(kind)}",
            here="simkit does not look at the type, as Gazebo.",
            gazebo="Gazebo does not look at the type; a real robot would.",
            remedy=f"Write {_SIMPLE}.",
        )


def _joint_faults(sheet: Sheet, joint: Element, moving: list[str], bad: Severity) -> Iterator[Find]:
    name = joint.get("name")
    entry = sheet.joint_by_name.get(name or "")
    if entry is not None and entry.type != "fixed":
        return
    what = f"the transmission is for {quoted(name)}, and there is no such joint"
    if entry is not None:
        what = f"the transmission is for {quoted(name)}, a fixed joint"
    advice = "Leave out the transmission, or give the joint a type that moves."
    yield Find(
        Part(joint, "name"),
        severity=bad,
        what=what,
        here="simkit leaves out the transmission.",
        gazebo="gazebo_ros_control says: This robot has a joint which is not in the gazebo model; no controller can use it.",
        remedy=joint_advice(sheet, name or "", moving) if entry is None else advice,
    )


def _interface_faults(
    transmission: TransmissionEntry, joint: Element, bad: Severity
) -> Iterator[Find]:
    element = joint.child("hardwareInterface")
    if element is None:
        yield _no_interface(transmission, joint, bad)
        return
    text = element.text.strip()
    bare = text.removeprefix(PREFIX)
    if bare not in INTERFACES:
        near = nearest(bare, INTERFACES)
        yield Find(
            Part(element),
            severity=Severity.WARNING if bare in _READ_ONLY else bad,
            what=f"there is no hardware interface {quoted(text)}",
            here="simkit refuses to control the joint.",
            gazebo="gazebo_ros_control stops: No matching hardware interface found.",
            remedy=meant([PREFIX + near]).strip()
            if near
            else f"There are: {listed((PREFIX + one for one in INTERFACES), 3)}.",
        )
    elif bare == text:
        yield Find(
            Part(element),
            severity=Severity.NOTE,
            what=f"the interface {quoted(text)} is written in the old way",
            here="simkit takes it.",
            gazebo="gazebo_ros_control takes it, and says: Deprecated syntax.",
            remedy=f"Write {PREFIX}{shown(text)}.",
        )


def _no_interface(transmission: TransmissionEntry, joint: Element, bad: Severity) -> Find:
    below = any(one.child("hardwareInterface") for one in transmission.actuators)
    where = ": it stands only in the <actuator>" if below else ""
    return Find(
        joint,
        severity=bad,
        what=f"the joint {quoted(joint.get('name'))} of the transmission has no <hardwareInterface>{where}",
        here=_SKIPPED.replace("gazebo_ros_control", "simkit"),
        gazebo=f"No valid hardware interface element found: {_SKIPPED}",
        remedy=f"Add <hardwareInterface>{PREFIX}{POSITION}</hardwareInterface> to this <joint>.",
    )


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
            Part(first),
            severity=Severity.WARNING,
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
            Part(element),
            what=what,
            here="simkit refuses to start the plugin.",
            gazebo="Joint ... does not exist! The plugin then crashes Gazebo.",
            remedy=remedy,
        )
