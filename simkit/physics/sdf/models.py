"""Models in SDF: links and joints."""

from __future__ import annotations

import math
from dataclasses import replace

from simkit.diagnostics import Severity
from simkit.physics.sdf.description import SdfJoint, SdfLink, SdfModel
from simkit.physics.sdf.links import read_link_element
from simkit.physics.sdf.page import Page
from simkit.physics.sdf.rules import NO_MASS
from simkit.urdf.model import Pose
from simkit.xml import Element

JOINT_TYPES = ("fixed", "revolute", "prismatic")
"""Types of joints that are simulated."""
WORLD = "world"
"""Name of what does not move, as the parent of a joint."""
NO_LIMIT = 1e15
"""Sdformat writes 1e16 where a joint has no limit."""

_MODEL = ["pose", "static", "self_collide", "link", "joint", "plugin"]
_MODEL_SILENT = ["allow_auto_disable", "enable_wind"]
_JOINT = ["pose", "parent", "child", "axis"]
_JOINT_SILENT = ["physics", "sensor"]
_AXIS = ["xyz", "limit", "dynamics", "use_parent_model_frame"]


def read_model_element(page: Page, element: Element) -> SdfModel:
    """A `<model>`.

    Raises:
        WorldFileError: A name is missing or there twice, or a joint names a link that is not there.
    """
    page.leave_out(element, _MODEL, silent=_MODEL_SILENT)
    name = element.get("name")
    if not name:
        raise page.refuse(element, "a <model> has no name", 'Write <model name="...">.')
    links = [read_link_element(page, child) for child in element.all("link")]
    _check_names(page, [link.element for link in links])
    if not links:
        page.say(element, f"the model {name} has no link", "Give it a <link>.")
    _note_masses(page, links, is_static=page.flag(element, "static"))
    joints = [one for child in element.all("joint") if (one := _joint(page, child, links))]
    _check_names(page, [joint.element for joint in joints])
    return SdfModel(
        name=name,
        pose=page.pose(element),
        is_static=page.flag(element, "static"),
        self_collide=page.flag(element, "self_collide"),
        links=tuple(links),
        joints=tuple(joints),
        plugins=tuple(element.all("plugin")),
    )


def renamed(
    model: SdfModel, *, name: str, pose: Pose | None, is_static: bool | None, uri: str
) -> SdfModel:
    """A model as an `<include>` wants it.

    Args:
        model: The model.
        name: Its name in the world; its own if empty.
        pose: Where it is; as it says itself if None.
        is_static: Whether nothing moves it; as it says itself if None.
        uri: What it was included from.
    """
    return replace(
        model,
        name=name or model.name,
        pose=model.pose if pose is None else pose,
        is_static=model.is_static if is_static is None else is_static,
        uri=uri,
    )


def _note_masses(page: Page, links: list[SdfLink], *, is_static: bool) -> None:
    for link in links:
        if link.inertial is None and not is_static:
            page.say(
                link.element,
                f"the link {link.name} has no <inertial>: it weighs 1 kg, and 1 kg m^2 turn with it",
                "Give it its mass and inertia.",
                severity=Severity.NOTE,
                rule=NO_MASS,
            )


def _joint(page: Page, element: Element, links: list[SdfLink]) -> SdfJoint | None:
    page.leave_out(element, _JOINT, silent=_JOINT_SILENT)
    kind, name = element.get("type") or "", element.get("name") or ""
    if kind not in JOINT_TYPES:
        page.say(
            element,
            f"the joint {name} is of type {kind!r}, which is not supported: {page.text(element, 'child')} is not held by it",
            f"Use one of {', '.join(JOINT_TYPES)}.",
        )
        return None
    parent, child = page.text(element, "parent"), page.text(element, "child")
    names = [link.name for link in links]
    for role, link in (("parent", parent), ("child", child)):
        if link not in names and not (link == WORLD and role == "parent"):
            listed = ", ".join(names)
            raise page.refuse(
                element.child(role) or element,
                f"the {role} of joint {name} is {link!r}, which is no link of its model",
                f"Links: {listed}.",
            )
    joint = SdfJoint(
        name=name, type=kind, parent=parent, child=child, pose=page.pose(element), element=element
    )
    axis = element.child("axis")
    return joint if axis is None or kind == "fixed" else _with_axis(page, joint, axis)


def _with_axis(page: Page, joint: SdfJoint, axis: Element) -> SdfJoint:
    page.leave_out(axis, _AXIS)
    xyz = axis.child("xyz")
    expressed = "" if xyz is None else xyz.get("expressed_in") or ""
    if xyz is not None and expressed not in ("", "__model__", joint.name, joint.child):
        page.say(
            xyz,
            f"the axis of {joint.name} is given in {expressed!r}, which is not supported",
            _AXIS_REMEDY,
        )
    limit, dynamics = axis.child("limit") or axis, axis.child("dynamics") or axis
    lower, upper = page.number(limit, "lower", -math.inf), page.number(limit, "upper", math.inf)
    return replace(
        joint,
        axis=page.vector(axis, "xyz", (0.0, 0.0, 1.0)),
        axis_in_model=page.version < (1, 5)
        or page.flag(axis, "use_parent_model_frame")
        or expressed == "__model__",
        lower=-math.inf if lower < -NO_LIMIT else lower,
        upper=math.inf if upper > NO_LIMIT else upper,
        effort=_bound(page.number(limit, "effort", -1.0)),
        velocity=_bound(page.number(limit, "velocity", -1.0)),
        damping=max(page.number(dynamics, "damping", 0.0), 0.0),
        friction=max(page.number(dynamics, "friction", 0.0), 0.0),
        stiffness=max(page.number(dynamics, "spring_stiffness", 0.0), 0.0),
        rest=page.number(dynamics, "spring_reference", 0.0),
    )


_AXIS_REMEDY = "Give it in the frame of the joint, or of the model (__model__)."


def _bound(value: float) -> float:
    return math.inf if value < 0.0 or value > NO_LIMIT else value


def _check_names(page: Page, elements: list[Element]) -> None:
    seen: set[str] = set()
    for element in elements:
        tag, name = element.name, element.get("name") or ""
        if not name:
            raise page.refuse(element, f"a <{tag}> has no name", f'Write <{tag} name="...">.')
        if name in seen:
            what = f"there are two of <{tag} name={name!r}>"
            raise page.refuse(element, what, "Give each a name of its own.")
        seen.add(name)
