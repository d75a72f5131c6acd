"""A rule on colours: URDF's are for RViz, Gazebo has its own."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

from simkit.diagnostics import Find, Part, Severity, rule
from simkit.urdf.model import Rgba
from simkit.urdf.rules.bodies import mass_of
from simkit.urdf.rules.entries import LinkEntry
from simkit.urdf.rules.sheet import Sheet
from simkit.urdf.rules.vocabulary import tag_value
from simkit.urdf.rules.wording import listed, quoted, shown
from simkit.xml import Element

COLOURS: Mapping[str, tuple[float, float, float]] = {
    "Black": (0.0, 0.0, 0.0),
    "Blue": (0.0, 0.0, 1.0),
    "DarkGrey": (0.175, 0.175, 0.175),
    "Gold": (0.8, 0.65, 0.19),
    "Green": (0.0, 1.0, 0.0),
    "Grey": (0.3, 0.3, 0.3),
    "Gray": (0.3, 0.3, 0.3),
    "Indigo": (0.33, 0.0, 0.5),
    "Orange": (1.0, 0.51, 0.05),
    "Purple": (1.0, 0.0, 1.0),
    "Red": (1.0, 0.0, 0.0),
    "SkyBlue": (0.13, 0.44, 0.7),
    "Turquoise": (0.0, 1.0, 1.0),
    "White": (1.0, 1.0, 1.0),
    "Yellow": (1.0, 1.0, 0.0),
    "ZincYellow": (0.97, 0.95, 0.2),
}
"""Materials of Gazebo that are one colour: red, green, blue from 0 to 1, as seen in plain light."""

PATTERNS = (
    "BlueGlow", "BlueLaser", "BlueTransparent", "BuildingFrame", "Bricks", "CeilingTiled",
    "CloudySky", "Chrome", "DarkGray", "DarkMagentaTransparent", "DarkOrangeTransparent",
    "DarkYellow", "DepthMap", "Editor", "FlatBlack", "Fish", "Footway", "Grass", "GrayGrid",
    "GreenGlow", "GreenTransparent", "GreyGradientSky", "GreyTransparent", "JointAnchor",
    "LaserGlow", "LightBlueLaser", "LightOff", "LightOn", "LtGreenTransparent", "Mud",
    "Orange", "OrangeTransparent", "PaintedWall", "PioneerBody", "Pedestrian", "PurpleGlow",
    "RedBright", "RedGlow", "RedTransparent", "RedTransparentOverlay", "Residential", "Road",
    "RustySteel", "RustyBarrel", "Runway", "Shell", "SkyBlue", "Smoke", "Spherical",
    "TrunkTexture", "TurquoiseGlow", "TurquoiseGlowOutline", "WaveDisplay", "WhiteGlow",
    "WireBox", "Wood", "WoodFloor", "WoodPallet", "WoodTile", "YellowGlow",
    "YellowTransparent", "Motorway", "Steep",
)  # fmt: skip
"""More materials of Gazebo, which are pictures, glow, or let light through."""

_PREFIX = "Gazebo/"
_OTHER = 0.6
"Two colours further apart than this, of at most 1.73, are not the same."


@rule("GZ-W13", "colours in RViz and in Gazebo", Severity.WARNING)
def gazebo_colours(sheet: Sheet) -> Iterator[Find]:
    """The colour in RViz and the colour in Gazebo.

    Symptom: A robot that is colourful in RViz is grey in Gazebo, or has other colours there.

    Cause: Gazebo does not read the `<material>` of URDF. It has materials of its own, such as `Gazebo/Orange`, which stand
    in a `<gazebo>` of the link, and it says nothing if there is none of that name.

    Remedy: Both, with the colours you want.

    Right:

        <gazebo reference="link_chassis">
          <material>Gazebo/Orange</material>
        </gazebo>
    """
    given = _gazebo_materials(sheet)
    for element in given.values():
        yield from _unknown(sheet, element)
    if not any(mass_of(link) for link in sheet.links):
        return
    colours = {one.name: one.rgba for one in reversed(sheet.materials) if one.rgba is not None}
    grey = []
    for link in sheet.links:
        rgba = _colour(link, colours)
        if rgba is None or link.name is None:
            continue
        if link.name not in given:
            grey.append((link, rgba))
        else:
            yield from _differs(link, rgba, given[link.name])
    if grey:
        yield _grey_in_gazebo(grey)


def _gazebo_materials(sheet: Sheet) -> dict[str, Element]:
    found: dict[str, Element] = {}
    for block in sheet.gazebo:
        element = block.element.child("material")
        if block.reference and element is not None and tag_value(element):
            found.setdefault(block.reference, element)
    return found


def _unknown(sheet: Sheet, element: Element) -> Iterator[Find]:
    name = tag_value(element)
    known = sorted({*COLOURS, *PATTERNS})
    if not name.startswith(_PREFIX) or name.removeprefix(_PREFIX) in known:
        return
    near = sheet.near(name.removeprefix(_PREFIX), known)
    if not near:
        return
    yield Find(
        Part(element),
        what=f"Gazebo has no material {quoted(name)}",
        here="simkit takes the colour of the URDF.",
        gazebo="Gazebo shows the link in its default colour.",
        remedy=f"Did you mean {' or '.join(quoted(_PREFIX + one) for one in near)}?",
    )


def _differs(link: LinkEntry, rgba: Rgba, element: Element) -> Iterator[Find]:
    name = tag_value(element).removeprefix(_PREFIX)
    if name not in COLOURS or math.dist(COLOURS[name], rgba[:3]) < _OTHER:
        return
    material = link.visuals[0].material_element
    near = _nearest(rgba)
    yield Find(
        Part(element),
        severity=Severity.NOTE,
        what=f"link {quoted(link.name)} has other colours in Gazebo ({name}) and in RViz",
        here="simkit shows the colour of the URDF in rviz, and that of the <gazebo> block in the world.",
        gazebo="Gazebo reads only <gazebo><material>, RViz only the <material> of the visual.",
        remedy=f"If they are to be the same: {_PREFIX}{near} is nearest to the one of the URDF.",
        related=() if material is None else [(material, "the colour in RViz")],
    )


def _grey_in_gazebo(grey: list[tuple[LinkEntry, Rgba]]) -> Find:
    link, rgba = grey[0]
    names = [*dict.fromkeys(one.name for one, _ in grey if one.name is not None)]
    return Find(
        link.visuals[0].material_element or link.element,
        severity=Severity.NOTE,
        what=f"colours that Gazebo will not show: {listed(names)}",
        here="simkit shows the colours of the URDF.",
        gazebo="Gazebo does not read the <material> of URDF: it shows the links grey.",
        remedy=f'To colour it there too: <gazebo reference="{shown(names[0])}"><material>{_PREFIX}{_nearest(rgba)}'
        "</material></gazebo>" + (", and so on." if len(names) > 1 else "."),
    )


def _colour(link: LinkEntry, colours: Mapping[str | None, Rgba | None]) -> Rgba | None:
    """The colour of the first visual of a link that has one."""
    for visual in link.visuals:
        if visual.material_element is not None:
            rgba = colours.get(visual.material_element.get("name"))
            if rgba is not None:
                return rgba
    return None


def _nearest(rgba: Rgba) -> str:
    return min(COLOURS, key=lambda name: math.dist(COLOURS[name], rgba[:3]))
