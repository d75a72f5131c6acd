"""Which rules there are: each is a generator that is decorated with its row, in the module of its subject.

A row has a stable id: `URDF-` (what is written), `GZ-`, `CTL-` (what the simulation makes of it) and their kin; E, W or I for
the worst that it reports (error, warning, note); and a number that is never used again.

A subject is loaded when a file has what it looks at, so that the answer for a small robot comes soon.
"""

from __future__ import annotations

import importlib
from collections.abc import Callable, Iterable, Mapping
from functools import cache

from simkit.diagnostics import Rule
from simkit.diagnostics.table import in_table_order, rules_in
from simkit.urdf.model import Mesh
from simkit.urdf.rules.sheet import Sheet


def rules_for(sheet: Sheet) -> tuple[Rule, ...]:
    """The rules that can find something in a file."""
    return _rules_of(topic for topic, has_matter in _TOPICS.items() if has_matter(sheet))


@cache
def all_rules() -> tuple[Rule, ...]:
    """All rules, by id within their group."""
    return in_table_order(_rules_of(_TOPICS))


def _rules_of(topics: Iterable[str]) -> tuple[Rule, ...]:
    modules = [importlib.import_module(f"{__package__}.{topic}") for topic in topics]
    return tuple(rule for module in modules for rule in rules_in(module))


def _is_malformed(sheet: Sheet) -> bool:
    return bool(sheet.document.faults) or sheet.document.has_wide_letters


def _is_odd_file(sheet: Sheet) -> bool:
    """Whether it is no `<robot>`, or one with more than a name."""
    robot = sheet.robot
    return robot is None or robot.name != "robot" or robot.attribute("version") is not None


def _is_robot(sheet: Sheet) -> bool:
    return sheet.robot is not None


def _has_joints(sheet: Sheet) -> bool:
    return bool(sheet.joints)


def _has_mimics(sheet: Sheet) -> bool:
    return any(joint.mimic_element is not None for joint in sheet.joints)


def _has_materials(sheet: Sheet) -> bool:
    return bool(sheet.materials)


def _has_meshes(sheet: Sheet) -> bool:
    bodies = (body for link in sheet.links for body in (*link.visuals, *link.collisions))
    return any(isinstance(body.shape, Mesh) for body in bodies)


def _has_bodies(sheet: Sheet) -> bool:
    """Whether any link has mass, or can be touched: a robot to simulate, not only to look at."""
    return any(link.inertial is not None or link.collisions for link in sheet.links)


def _has_world(sheet: Sheet) -> bool:
    return _is_for_gazebo(sheet) and any(link.name == "world" for link in sheet.links)


def _is_for_gazebo(sheet: Sheet) -> bool:
    return bool(sheet.gazebo) or _has_bodies(sheet)


def _has_gazebo(sheet: Sheet) -> bool:
    return bool(sheet.gazebo)


def _has_plugins(sheet: Sheet) -> bool:
    return bool(sheet.plugins)


def _has_drive(sheet: Sheet) -> bool:
    return any("drive" in (plugin.filename or "") for plugin in sheet.plugins)


def _has_control(sheet: Sheet) -> bool:
    return bool(sheet.plugins or sheet.transmissions or sheet.companions)


def _has_companions(sheet: Sheet) -> bool:
    return bool(sheet.companions)


_TOPICS: Mapping[str, Callable[[Sheet], bool]] = {
    "xml_faults": _is_malformed,
    "whole_file": _is_odd_file,
    **dict.fromkeys(("tree", "names", "parts", "words", "stray_text", "numbers"), _is_robot),
    **dict.fromkeys(("degrees", "rounded_angles", "sizes", "mass", "namespaces"), _is_robot),
    **dict.fromkeys(("joint_types", "limits", "axes"), _has_joints),
    "mimics": _has_mimics,
    "materials": _has_materials,
    "meshes": _has_meshes,
    **dict.fromkeys(("tensor", "tensor_and_shape", "tensor_slip"), _has_bodies),
    **dict.fromkeys(("shape_places", "spawn_pose"), _has_bodies),
    **dict.fromkeys(("gazebo_blocks", "colours"), _is_for_gazebo),
    "world_link": _has_world,
    **dict.fromkeys(("plugins", "plugin_names", "joint_lists"), _has_plugins),
    **dict.fromkeys(("drive", "drive_force"), _has_drive),
    "sensors": _has_gazebo,
    "transmissions": _has_control,
    **dict.fromkeys(("controllers", "launch_files", "launch_description"), _has_companions),
}
"""Modules of rules in this folder, each with what a file must have for them to find anything."""
