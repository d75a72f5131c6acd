"""Rules on mass: links that have none, and what Gazebo then leaves out."""

from __future__ import annotations

from collections.abc import Iterator

from simkit.diagnostics import Find, Part, Severity, rule
from simkit.urdf.placed_shape import volume
from simkit.urdf.rules.bodies import LIGHTEST, Lump, is_world, lumps, mass_of, solid
from simkit.urdf.rules.entries import LinkEntry
from simkit.urdf.rules.sheet import Sheet
from simkit.urdf.rules.tree_facts import is_whole
from simkit.urdf.rules.wording import called, four_digits, inertial_text, listed, quoted

_SMALL_BODY = (
    '<inertial><mass value="0.1"/>'
    '<inertia ixx="0.0001" ixy="0" ixz="0" iyy="0.0001" iyz="0" izz="0.0001"/></inertial>'
)
"A ball of 0.1 kg and 5 cm, for a link without a shape."

_COUNTED = 50
"So many links that are lost with another are counted."

_OTHERS = "simkit does as Gazebo does; DART and Bullet alone would make it 1 kg, with an inertia of 1 kg m^2."


@rule("URDF-W10", "a link without mass and inertia", Severity.WARNING)
def no_inertial(sheet: Sheet) -> Iterator[Find]:
    """A link has no `<inertial>`, so it has no mass.

    Symptom: In RViz all is well. In Gazebo the link is missing, and everything that hangs on it; of a root link without
    mass the whole robot is missing. Other simulators invent 1 kg, and the robot is oddly heavy.

    Cause: URDF allows a link without `<inertial>`, and RViz needs none. Gazebo cannot move a body without mass, so it
    leaves it out without a word. Two links need no mass: `world`, which is the ground, and a link that a fixed joint ties
    to one that has mass, since Gazebo makes one body of both.

    Remedy: Give each link that moves a mass and an inertia. A robot that is only looked at, as in the first exercises,
    needs none.

    Right:

        <link name="torso">
          <inertial>
            <origin xyz="0 0 0.25"/>
            <mass value="1.0"/>
            <inertia ixx="0.02146" ixy="0" ixz="0" iyy="0.02146" iyz="0" izz="0.00125"/>
          </inertial>
        </link>
    """
    bare = [link for link in sheet.links if link.inertial is None]
    if len(bare) == len(sheet.links):
        yield from _robot_to_look_at(sheet)
        return
    lump_of, density, whole = lumps(sheet), _density(sheet), is_whole(sheet)
    for link in bare:
        if link.name is None or is_world(sheet, link.name):
            continue
        lump = lump_of[link.name]
        if not lump.mass and lump.leader is link and (whole or not _is_torn_off(sheet, link)):
            yield _left_out(sheet, lump, density)
        elif lump.mass and link.collisions:
            yield _shape_without_mass(link, lump, density)


@rule("URDF-W40", "a mass of zero, or a negative one", Severity.ERROR)
def no_mass(sheet: Sheet) -> Iterator[Find]:
    """A mass is zero or negative.

    Symptom: Gazebo leaves the link out, or refuses the robot; the engine divides by the mass, so motions explode.

    Cause: A zero that was meant to say "it does not matter", or a sign that slipped in. Gazebo counts less than 0.01 g as
    none.

    Remedy: Write what the part weighs, in kilograms. A frame that is only a name needs no `<inertial>` at all: tie it by a
    fixed joint to a link with mass.

    Right:

        <mass value="0.2"/>
    """
    lump_of, density = lumps(sheet), _density(sheet)
    for link in sheet.links:
        mass = None if link.inertial is None else link.inertial.mass
        if mass is None or mass > LIGHTEST or is_world(sheet, link.name):
            continue
        if mass < -LIGHTEST:
            yield _negative(link, mass)
        else:
            yield _zero(sheet, link, lump_of.get(link.name or ""), density)


@rule(
    "URDF-I45",
    "a root link with a mass",
    Severity.NOTE,
    here="simkit computes all frames and the simulation with it.",
    gazebo="robot_state_publisher warns: KDL does not support a root link with an inertia. Gazebo has no trouble.",
)
def root_inertia(sheet: Sheet) -> Iterator[Find]:
    """The root link has a mass.

    Symptom: robot_state_publisher warns that KDL does not support a root link with an inertia.

    Cause: KDL, the library that computes the frames for ROS, gives its trees a root without mass. Frames and Gazebo are not
    touched by it; only dynamics that are computed with KDL ignore that mass.

    Remedy: Put an empty link, usually `base_link` or `base_footprint`, above it, with a fixed joint.

    Right:

        <link name="base_link"/>
        <joint name="base_joint" type="fixed">
          <parent link="base_link"/>
          <child link="chassis"/>
        </joint>
    """
    for link in sheet.links if is_whole(sheet) else ():
        if sheet.is_root(link) and mass_of(link) and link.inertial is not None:
            below = "base_link" if link.name != "base_link" else "base_footprint"
            yield Find(
                link.inertial.element,
                what=f"the root link {quoted(link.name)} has a mass",
                remedy=f'To be rid of the warning add <link name="{below}"/> and a fixed joint from it to {quoted(link.name)}.',
            )


def _robot_to_look_at(sheet: Sheet) -> Iterator[Find]:
    shown = [link for link in sheet.links if link.visuals or link.collisions]
    if sheet.robot is None or not shown or not is_whole(sheet):
        return
    touched = any(link.collisions for link in shown)
    without = "a mass" if touched else "a mass or a collision shape"
    yield Find(
        sheet.robot,
        severity=Severity.NOTE,
        what=f"no link has {without}: a robot to look at, not to simulate",
        here="RViz and TF need neither. Spawned in a world it would be an empty model.",
        gazebo="Gazebo would spawn an empty model: it leaves out links without a mass.",
        remedy="Right as it is for RViz. For a simulation give each link an <inertial> and a <collision>.",
    )


def _is_torn_off(sheet: Sheet, link: LinkEntry) -> bool:
    """Whether it may be for a wrong name at a joint that a link belongs to no other body; a find about that is enough."""
    joint = next(iter(sheet.joints_above.get(link.name or "", ())), None)
    return joint is None or (joint.type == "fixed" and joint.parent not in sheet.link_by_name)


def _left_out(sheet: Sheet, lump: Lump, density: float | None) -> Find:
    link = lump.leader
    if sheet.is_root(link):
        what = f"the root link {quoted(link.name)} has no mass, and moving joints hang on it"
        gazebo = (
            "Gazebo leaves out a link without mass and all below it: the whole robot is missing."
        )
    else:
        what = f"{called(link.element)} has no <inertial>, so it has no mass"
        gazebo = f"Gazebo leaves out the link{_and_below(sheet, link.name)}, without a word."
    return Find(
        link.element,
        what=what,
        here=_OTHERS,
        gazebo=gazebo,
        remedy=_inertial_remedy(link, density),
    )


def _shape_without_mass(link: LinkEntry, lump: Lump, density: float | None) -> Find:
    return Find(
        link.element,
        severity=Severity.NOTE,
        what=f"{called(link.element)} has a collision shape, but no mass",
        here=_OTHERS,
        gazebo=_carried(lump),
        remedy=_inertial_remedy(link, density),
    )


def _carried(lump: Lump) -> str:
    names = [link.name for link in lump.members if mass_of(link)]
    return f"Gazebo makes it one body with {quoted(names[0])}, which carries the mass: nothing is lost."


def _inertial_remedy(link: LinkEntry, density: float | None) -> str:
    shapes = solid(link)
    if not shapes:
        return f"Add to the link, with its real mass: {_SMALL_BODY}."
    mass = 1.0 if density is None else density * sum(volume(one.shape) for one in shapes)
    mass = max(float(f"{mass:.2g}"), 10 * LIGHTEST)
    only = (link.collisions or link.visuals)[0].origin if len(shapes) == 1 else None
    guess = "" if density is None else " (its shape, as dense as the other links)"
    return f"Add to the link, with its real mass{guess}: {inertial_text(shapes, only, mass)}."


def _density(sheet: Sheet) -> float | None:
    """Mass per volume of the links that have both [kg/m^3]; None if there are none."""
    pairs = [(mass_of(link), solid(link)) for link in sheet.links if mass_of(link)]
    masses = sum(mass for mass, shapes in pairs if shapes)
    volumes = sum(volume(one.shape) for _, shapes in pairs for one in shapes)
    return masses / volumes if volumes else None


def _negative(link: LinkEntry, mass: float) -> Find:
    return Find(
        _mass_value(link),
        what=f"{called(link.element)} has a mass of {four_digits(mass)} kg",
        here="simkit refuses to simulate the robot.",
        gazebo="Newer Gazebo refuses the link (error 18, invalid inertia); in older ones it flies apart.",
        remedy=f"Write {four_digits(-mass)} if only the sign slipped in: a mass is more than 0 kg.",
    )


def _zero(sheet: Sheet, link: LinkEntry, lump: Lump | None, density: float | None) -> Find:
    is_carried = lump is not None and lump.mass > 0.0
    shapes = solid(link)
    remedy = "Write its mass in kilograms; or tie it by a fixed joint to a link with mass, if it is only a frame."
    if shapes and density is not None:
        guess = four_digits(density * sum(volume(one.shape) for one in shapes))
        remedy = f"Write its mass in kilograms: as dense as the other links, its shape weighs {guess} kg."
    return Find(
        _mass_value(link),
        severity=Severity.NOTE if is_carried else Severity.WARNING,
        what=f"{called(link.element)} has no mass that counts: it must be more than {LIGHTEST:g} kg",
        here="simkit gives the link no mass, as Gazebo does.",
        gazebo=_carried(lump)
        if lump is not None and is_carried
        else f"Gazebo leaves out the link{_and_below(sheet, link.name)}, without a word.",
        remedy=remedy,
    )


def _mass_value(link: LinkEntry) -> Part:
    element = None if link.inertial is None else link.inertial.mass_element
    return Part(element or link.element, "value")


def _and_below(sheet: Sheet, name: str | None) -> str:
    """The links that hang on one, in words: ` and what hangs on it ('a', 'b')`."""
    found: dict[str, None] = {}
    waiting = [name or ""]
    while waiting and len(found) < _COUNTED:
        for joint in sheet.joints_below.get(waiting.pop(), ()):
            if joint.child in sheet.link_by_name and joint.child not in found and joint.child:
                found[joint.child] = None
                waiting.append(joint.child)
    if not found:
        return ""
    return f" and what hangs on it ({listed(found)})"
