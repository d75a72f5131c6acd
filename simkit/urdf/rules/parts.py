"""Rules about parts of an element that are missing, or that stand there twice."""

from __future__ import annotations

from collections.abc import Iterator

from simkit.diagnostics import Find, Severity, rule
from simkit.urdf.rules.bodies import fitting_tensor
from simkit.urdf.rules.sheet import Sheet
from simkit.urdf.rules.tree_facts import free_end
from simkit.urdf.rules.vocabulary import (
    SHAPES,
    WORDS,
    in_context,
    meant_attribute,
    meant_children,
    meant_word,
)
from simkit.urdf.rules.wording import (
    called,
    loss,
    mended,
    part_of,
    read_number,
    shown,
    six_digits,
    tensor_text,
)
from simkit.xml import Element

_OTHER_RULES = ("robot", "link", "material", "axis", "color")
"Their attributes are matters of other rules: names, axes, colours."
_EXAMPLES = {
    **{"effort": "10", "velocity": "1", "k_velocity": "1", "value": "1", "type": "fixed"},
    **{"ixx": "0.01", "iyy": "0.01", "izz": "0.01", "ixy": "0", "ixz": "0", "iyz": "0"},
    **{"size": "0.1 0.1 0.1", "radius": "0.1", "length": "0.2", "damping": "0.1"},
    "filename": "package://my_robot/...",
}
_VECTORS = ("size",)


def missing_attributes(element: Element, word: str) -> list[str]:
    """Attributes that an element must have and has not, not even misspelt; another rule reports names."""
    if word in _OTHER_RULES:
        return []
    required = [name for name in WORDS[word].required if name != "name"]
    missing = [name for name in required if meant_attribute(element, name, word) is None]
    if word in ("parent", "child") and not missing and not element.get("link", "-"):
        return ["link"]  # an empty name is none
    if word == "dynamics":
        either = ("damping", "friction")
        given = any(meant_attribute(element, name, word) is not None for name in either)
        return [] if given else ["damping"]
    return missing


def wanted_text(element: Element, word: str, missing: list[str]) -> str:
    """What to write, for a person: with the value that stands elsewhere in the element, if there is one.

    Args:
        element: The element that lacks them.
        word: What it is meant to be.
        missing: The attributes that it lacks.
    """
    values = {name: _elsewhere(element, name, only=len(missing) == 1) for name in missing}
    written = " ".join(
        f'{name}="{value or _EXAMPLES.get(name, "...")}"' for name, value in values.items()
    )
    if any(value is not None for value in values.values()):
        if element.attribute("diameter") is not None:
            return f"URDF has the radius, half of the diameter: write {written}."
        return f"Values stand in attributes: write <{word} {written}/>."
    return f"Add {written}."


def _elsewhere(element: Element, name: str, *, only: bool) -> str | None:
    """The value of an attribute that is written otherwise: as SDF does, in an element or as text, or as a diameter."""
    if name == "radius" and element.get("diameter") is not None:
        diameter = read_number(mended(element.get("diameter") or "", 1))
        return None if diameter is None else six_digits(diameter / 2)
    inner = element.child(name)
    text = inner.text if inner is not None else element.text if only else ""
    text = " ".join(text[:200].split())
    if not text:
        return None
    count = 3 if name in _VECTORS else 1
    return mended(text, count) or shown(text)


_NEEDED = {
    "inertial": {
        "mass": '<mass value="1"/>',
        "inertia": '<inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>',
    },
    "visual": {"geometry": '<geometry><box size="0.1 0.1 0.1"/></geometry>'},
    "collision": {"geometry": '<geometry><box size="0.1 0.1 0.1"/></geometry>'},
    "joint": {"parent": '<parent link="..."/>', "child": '<child link="..."/>'},
}
_OTHER_SHAPES = {
    **dict.fromkeys(("cube", "cuboid", "rectangle"), '<box size="0.1 0.1 0.1"/>'),
    **dict.fromkeys(("ball", "circle", "ellipsoid"), '<sphere radius="0.1"/>'),
    **dict.fromkeys(("tube", "disk", "disc", "cone"), '<cylinder radius="0.1" length="0.2"/>'),
    "plane": '<box size="10 10 0.01"/>',
    "capsule": "a <cylinder/> with two <sphere/>s at its ends, each in a visual or collision of its own",
}


@rule("URDF-E25", "an attribute that must be there is missing", Severity.ERROR)
def attribute_missing(sheet: Sheet) -> Iterator[Find]:
    """An element without an attribute that it must have.

    In a joint, ROS refuses the robot (`joint limit: no effort`). In a link, it loses the rest of the link and goes on: with an
    inertia that lacks `iyz`, the mass, the visuals and the collisions of the link are gone, and check_urdf still says
    "Successfully Parsed XML". Mind who writes values as SDF does, as text: URDF has them in attributes.

    Wrong:

        <mass>1.0</mass>
        <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" izz="0.01"/>

    Right:

        <mass value="1.0"/>
        <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
    """
    for element, word in in_context(sheet.robot):
        missing = missing_attributes(element, word)
        if missing:
            follows = loss(element)
            names = " and ".join(missing) if len(missing) < 3 else ", ".join(missing)
            yield Find(
                element,
                what=f"<{shown(element.name)}> of {part_of(element)} lacks {names}",
                remedy=_end_text(sheet, element, word) or wanted_text(element, word, missing),
                loss=follows,
            )


@rule("URDF-E26", "a part that must be there is missing, or an unknown shape", Severity.ERROR)
def element_missing(sheet: Sheet) -> Iterator[Find]:
    """An element without a part that it must have.

    A joint needs a parent and a child, a visual and a collision need a geometry, a geometry needs a box, cylinder, sphere or
    mesh, an inertial needs a mass and an inertia, a robot needs a link. ROS refuses a joint without its ends; in a link it
    loses what follows and goes on.

    Wrong:

        <visual>
          <origin xyz="0 0 0.1"/>
        </visual>

    Right:

        <visual>
          <origin xyz="0 0 0.1"/>
          <geometry><box size="0.1 0.1 0.2"/></geometry>
        </visual>
    """
    if sheet.robot is None:
        return
    if not sheet.links:
        yield _lacking(sheet.robot, "link", '<link name="base_link"/>')
    for element, word in in_context(sheet.robot):
        if word == "geometry":
            yield from _no_shape(element)
        if word in _NEEDED:
            parts = meant_children(element, word)
            for name, example in _NEEDED[word].items():
                if not parts[name]:
                    yield _lacking(element, name, _computed(sheet, element, name) or example)


def _end_text(sheet: Sheet, element: Element, word: str) -> str:
    """What to write into a `<parent/>` or `<child/>` that names no link; nothing if that is not clear."""
    is_end = word in ("parent", "child") and element.parent is not None and not element.text.strip()
    link = free_end(sheet, element.parent or element, word) if is_end else ""
    return link and f'Write <{word} link="{shown(link)}"/>.'


def _computed(sheet: Sheet, element: Element, name: str) -> str:
    """What a part should be, where the rest of the robot says so: the inertia of the shape, the link that nobody names."""
    if name == "inertia":
        parent = element.parent
        link = None if parent is None else sheet.link_by_name.get(parent.get("name") or "")
        tensor = None if link is None or link.element is not parent else fitting_tensor(link)
        return "" if tensor is None else tensor_text(tensor)
    if name in ("parent", "child"):
        link_name = free_end(sheet, element, name)
        return link_name and f'<{name} link="{shown(link_name)}"/>'
    return ""


def _lacking(element: Element, name: str, example: str) -> Find:
    follows = loss(element)
    whole = called(element) if element.parent is None or element.name == "joint" else ""
    return Find(
        element,
        what=f"{whole or part_of(element)} has no <{name}>",
        remedy=f"Add one, e.g. {example}.",
        loss=follows,
    )


def _no_shape(geometry: Element) -> Iterator[Find]:
    shape = geometry.children[0] if geometry.children else None
    if shape is not None and (shape.name in SHAPES or meant_word(shape, SHAPES) is not None):
        return  # the rule of unknown words reports misspelt ones
    follows = loss(geometry)
    known = "URDF knows <box>, <cylinder>, <sphere> and <mesh>."
    what = f"the geometry of {part_of(geometry)} is empty"
    remedy = f'{known} Write e.g. <box size="0.1 0.1 0.1"/>.'
    if shape is not None:
        what = f"<{shown(shape.name)}> in {part_of(geometry)} is no shape that URDF knows"
        other = _OTHER_SHAPES.get(shape.name.lower())
        remedy = f"{known} Take {other}." if other else known
    yield Find(
        shape or geometry,
        what=what,
        remedy=remedy,
        loss=follows,
    )


@rule(
    "URDF-W35",
    "a part stands there twice, and only the first one counts",
    Severity.WARNING,
    both="It is not looked at.",
)
def repeated_part(sheet: Sheet) -> Iterator[Find]:
    """A part that may stand there once stands there twice.

    Only the first one counts, and nothing is said. A second visual or collision is fine; a second origin, geometry, inertial,
    axis, parent or child is not. Mostly a `</visual>` and a new `<visual>` are missing between the two.

    Wrong:

        <visual>
          <geometry><box size="0.1 0.1 0.1"/></geometry>
          <geometry><sphere radius="0.1"/></geometry>
        </visual>

    Right:

        <visual>
          <geometry><box size="0.1 0.1 0.1"/></geometry>
        </visual>
        <visual>
          <geometry><sphere radius="0.1"/></geometry>
        </visual>
    """
    for element, word in in_context(sheet.robot):
        for name, found in meant_children(element, word).items():
            if len(found) > 1 and name not in WORDS[word].many:
                yield _repeated(name, found[1], found[0])
        shapes = element.children if word == "geometry" else []
        if len(shapes) > 1 and shapes[0].name != shapes[1].name:
            yield _repeated("shape", shapes[1], shapes[0])


def _repeated(name: str, second: Element, first: Element) -> Find:
    in_visual = name in ("geometry", "shape")
    whole = part_of(second.parent or second)
    return Find(
        second,
        what=f"a second {name} in {whole}: only the first one counts",
        remedy="Give it a visual or collision of its own."
        if in_visual
        else "Take one of them out.",
        related=[(first, "this one counts")],
    )
