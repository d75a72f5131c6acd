"""What can be wrong with the controllers of a YAML file beside a URDF."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from simkit.diagnostics import Find, Severity, rule
from simkit.plugins.control.registry import CONTROLLER_TYPES, FAMILIES
from simkit.urdf.rules.companions import Faulty, ListedController, gains_below, listed_controllers
from simkit.urdf.rules.plugin_joints import joint_advice, moving_joints
from simkit.urdf.rules.sheet import CompanionKind, Sheet
from simkit.urdf.rules.vocabulary import nearest
from simkit.urdf.rules.wording import listed, meant, quoted, shown

_SINGLE = ("JointPositionController", "JointVelocityController", "JointEffortController")
_GROUP = (
    "JointTrajectoryController",
    "JointGroupPositionController",
    "JointGroupVelocityController",
    "JointGroupEffortController",
)
_NEEDED = {family: interface for interface, family in FAMILIES.items()}
_TYPES = tuple(CONTROLLER_TYPES)
_SOME = [f"{family}/JointTrajectoryController" for family in FAMILIES.values()]
_ELSEWHERE = (
    "diff_drive_controller/DiffDriveController",
    "position_controllers/GripperActionController",
    "effort_controllers/GripperActionController",
)
"Types that ros_controllers has besides."


def controller_faults(sheet: Sheet, offered: Mapping[str, str | None]) -> Iterator[Find]:
    """What does not fit between controllers, joints and transmissions.

    Args:
        sheet: The URDF and the files beside it.
        offered: The interface of each joint in its transmissions.
    """
    moving = moving_joints(sheet)
    for companion in sheet.companions:
        if companion.kind is not CompanionKind.YAML:
            continue
        found = listed_controllers(companion)
        if isinstance(found, Faulty):
            yield Find(
                found.span,
                severity=Severity.ERROR,
                companion=companion,
                what=f"the file is no YAML: {found.problem}",
                here="simkit refuses the file.",
                gazebo="rosparam refuses the file, and roslaunch stops.",
                remedy="Indent with blanks, not with tabs, and put one blank behind each colon.",
            )
            continue
        for controller in found:
            yield from _type_faults(controller, moving)
            yield from _joint_faults(sheet, controller, offered, moving)


@rule("CTL-I03", "controllers with gains, and without", Severity.WARNING)
def gains(sheet: Sheet) -> Iterator[Find]:
    """Controllers with gains, and without.

    Symptom: A red line `No p gain specified for pid`, or an arm that hangs down although its controller runs.

    Cause: A controller of forces (`effort_controllers/...`) computes the force from the error, by its gains; without gains
    it is 0. A controller of positions (`position_controllers/...`) needs none: the joint simply goes where it is sent.
    Gazebo asks for gains of its own for it, complains that there are none, and does without.

    Remedy: `gains` for controllers of forces and speeds. For controllers of positions ignore the line.

    Right:

        shoulder_controller:
          type: effort_controllers/JointPositionController
          joint: shoulder
          pid: {p: 100.0, i: 0.01, d: 10.0}
    """
    for companion in sheet.companions:
        found = listed_controllers(companion) if companion.kind is CompanionKind.YAML else []
        if isinstance(found, Faulty):
            continue
        for controller in found:
            if _lacks_gains(controller):
                yield Find(
                    controller.name.span,
                    severity=Severity.WARNING,
                    companion=controller.companion,
                    what=f"the controller {quoted(controller.name.text)} computes forces or speeds, and has no gains",
                    here="simkit takes gains of 0: the controller does nothing.",
                    gazebo="No p gain specified for pid: the controller does nothing.",
                    remedy=_gains_remedy(controller),
                )
        positions = [one for one in found if one.type and one.type.text.startswith("position_controllers/")]  # fmt: skip
        if positions and not any(gains_below(one) for one in sheet.companions):
            yield Find(
                positions[0].name.span,
                severity=Severity.NOTE,
                companion=positions[0].companion,
                what="Gazebo will print in red: No p gain specified for pid",
                here="simkit needs no gains for controllers of positions, and prints nothing.",
                gazebo="Harmless: joints with a PositionJointInterface go where they are told, without gains.",
                remedy="Nothing is to be done.",
            )


def _type_faults(controller: ListedController, moving: list[str]) -> Iterator[Find]:
    name, kind = quoted(controller.name.text), controller.type
    if kind is None:
        yield Find(
            controller.name.span,
            severity=Severity.ERROR,
            companion=controller.companion,
            what=f"the controller {name} has no type",
            here="simkit refuses to load the controller.",
            gazebo="Could not load controller, because the type was not specified.",
            remedy="Add type: position_controllers/JointTrajectoryController, or whichever it is.",
        )
        return
    if kind.text not in _TYPES:
        near = None if kind.text in _ELSEWHERE else nearest(kind.text, _TYPES)
        family = kind.text.partition("/")[0]
        is_foreign = kind.text in _ELSEWHERE or (near is None and family not in _NEEDED)
        yield Find(
            kind.span,
            severity=Severity.NOTE if is_foreign else Severity.ERROR,
            companion=controller.companion,
            what=f"there is no controller of type {quoted(kind.text)}{' in simkit' if is_foreign else ''}",
            here="simkit refuses to load the controller.",
            gazebo="Gazebo loads it if it is installed, else it says: controller type does not exist.",
            remedy=meant([near]).strip() if near else f"Some of them: {listed(_SOME)}.",
        )
    yield from _no_joints(controller, kind.text.rpartition("/")[2], moving)


def _no_joints(controller: ListedController, kind: str, moving: list[str]) -> Iterator[Find]:
    """A controller of a kind that needs joints, and names none."""
    wanted = "joints" if kind in _GROUP else "joint" if kind in _SINGLE else None
    if wanted is None or controller.joints:
        return
    every = f"[{', '.join(moving[:20])}]" if wanted == "joints" else (moving or ["hip"])[0]
    yield Find(
        controller.name.span,
        severity=Severity.ERROR,
        companion=controller.companion,
        what=f"the controller {quoted(controller.name.text)} names no joints",
        here="simkit refuses to load the controller.",
        gazebo=f"Could not find '{wanted}' parameter.",
        remedy=f"Add {wanted}: {shown(every)}.",
    )


def _joint_faults(
    sheet: Sheet, controller: ListedController, offered: Mapping[str, str | None], moving: list[str]
) -> Iterator[Find]:
    family = "" if controller.type is None else controller.type.text.partition("/")[0]
    needed = _NEEDED.get(family)
    for joint in controller.joints or ():
        entry = sheet.joint_by_name.get(joint.text)
        interface = offered.get(joint.text)
        if entry is None:
            what = f"the controller {quoted(controller.name.text)} moves {quoted(joint.text)}, and there is no such joint"
            remedy = joint_advice(sheet, joint.text, moving)
        elif needed is None or interface == needed:
            continue
        elif joint.text not in offered:
            what = f"no transmission offers {quoted(joint.text)} to the controller {quoted(controller.name.text)}"
            remedy = f"Add a <transmission> with <joint name={quoted(joint.text)}> and {needed}."
        elif interface is None:
            continue  # the transmission is reported
        else:
            what = f"the controller {quoted(controller.name.text)} needs {needed}, and the transmission of "
            what += f"{quoted(joint.text)} offers {quoted(interface)}"
            remedy = f"Write hardware_interface/{needed} in the transmission, or take {_fitting(interface, controller)}."
        yield Find(
            joint.span,
            severity=Severity.ERROR,
            companion=controller.companion,
            what=what,
            here="simkit refuses to start the controller.",
            gazebo=f"Could not find joint '{shown(joint.text)}' in 'hardware_interface::{needed or 'JointStateInterface'}'.",
            remedy=remedy,
        )


def _fitting(interface: str, controller: ListedController) -> str:
    """A type of controller for an interface."""
    kind = "JointTrajectoryController" if controller.type is None else controller.type.text.rpartition("/")[2]  # fmt: skip
    family = next((one for one, needs in _NEEDED.items() if needs == interface), None)
    return "a controller for that interface" if family is None else f"{family}/{kind}"


def _lacks_gains(controller: ListedController) -> bool:
    kind = "" if controller.type is None else controller.type.text
    family, _, name = kind.partition("/")
    if family not in ("effort_controllers", "velocity_controllers"):
        return False
    feeds_through = {
        "effort_controllers": ("JointEffortController", "JointGroupEffortController"),
        "velocity_controllers": ("JointVelocityController", "JointGroupVelocityController"),
    }[family]
    has_gains = controller.keys & {"gains", "pid"} or any("pid" in key for key in controller.keys)
    return name in (*_GROUP, *_SINGLE) and name not in feeds_through and not has_gains


def _gains_remedy(controller: ListedController) -> str:
    is_group = controller.type is not None and controller.type.text.endswith(_GROUP)
    values = "{p: 100.0, i: 0.01, d: 10.0}"
    if not is_group:
        return f"Add pid: {values}, and try out the numbers."
    names = ", ".join(f"{joint.text}: {values}" for joint in (controller.joints or ())[:2])
    return f"Add gains: {{{names}}}, and try out the numbers."
