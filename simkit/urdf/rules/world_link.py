"""A rule on the root link `world`, which is the ground and nothing else."""

from __future__ import annotations

from collections.abc import Iterator

from simkit.diagnostics import Find, Severity, rule
from simkit.urdf.fixed_joints import WORLD
from simkit.urdf.rules.entries import LinkEntry
from simkit.urdf.rules.lumps import is_world
from simkit.urdf.rules.sheet import Sheet


@rule(
    "GZ-W15",
    "a root link called world that has a shape or a mass",
    Severity.WARNING,
    here="rviz shows it; in a world it is left out, as in Gazebo, and the robot is tied to the ground.",
    gazebo="Gazebo leaves out the link with all that it has, and ties its joints to the ground, without a word.",
    remedy='Call it otherwise, e.g. name="base_link"; to tie it down, add <link name="world"/> and a fixed joint.',
)
def world_with_a_body(sheet: Sheet) -> Iterator[Find]:
    """A root link called `world` that has a shape or a mass.

    Symptom: RViz shows the base of the robot; in Gazebo it is missing, and the robot stands screwed to nothing.

    Cause: A root link of the name `world` is the ground of Gazebo. Gazebo makes no link of it, and drops its shapes and its
    mass; the joints below it tie the robot to the ground.

    Remedy: Leave `<link name="world"/>` empty. What is seen and touched belongs into a link of its own below it.

    Right:

        <link name="world"/>
        <joint name="stand" type="fixed">
          <parent link="world"/>
          <child link="base_link"/>
        </joint>
    """
    link = sheet.link_by_name.get(WORLD)
    if link is None or not is_world(sheet, WORLD) or not _parts(link):
        return
    yield Find(
        link.element.attribute("name") or link.element,
        element=link.element,
        what=f"the root link 'world' has {' and '.join(_parts(link))}, but Gazebo takes it for the ground",
    )


def _parts(link: LinkEntry) -> list[str]:
    parts = {
        "a visual": bool(link.visuals),
        "a collision": bool(link.collisions),
        "a mass": link.inertial is not None,
    }
    return [name for name, is_there in parts.items() if is_there]
