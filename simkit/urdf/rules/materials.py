"""Rules about materials: not defined, defined differently, colours out of range."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from simkit.diagnostics import Find, Part, Severity, rule
from simkit.urdf.rules.entries import MaterialEntry
from simkit.urdf.rules.sheet import Sheet
from simkit.urdf.rules.vocabulary import meant_attribute
from simkit.urdf.rules.wording import (
    meant,
    mended,
    numbers_text,
    quoted,
    read_number,
    shown,
    six_digits,
)
from simkit.xml import Attribute, Element

_GREY = "the shape is drawn in a default colour"
_GREY_RGBA = "0.75 0.75 0.75 1"
_MOST_CUT = 2.0
"Of numbers up to this what is too much is cut off; larger ones are on a scale to 100 or 255."


@rule("URDF-W22", "a material that is not defined, or defined in two ways", Severity.WARNING)
def undefined_material(sheet: Sheet) -> Iterator[Find]:
    """A material that nobody defines, or that is defined more than once.

    The part appears in grey or red, not in its colour; ROS prints `material 'sliver' undefined` and goes on. A material that
    several visuals share is defined best at the top, in the robot itself. If it is defined in a visual, the visuals that only
    name it must stand behind. Of two definitions of a name the first one counts.

    Wrong, if nothing defines `sliver`:

        <material name="sliver"/>

    Right:

        <material name="silver">
          <color rgba="0.75 0.75 0.75 1"/>
        </material>
    """
    defined = _definitions(sheet)
    names = {name: one for name, one in defined.items() if one.is_global}
    known = sorted(defined)
    uses = Counter(one.name for one in sheet.materials)
    reported: set[str] = set()
    for material in sheet.materials:
        if not material.name:
            continue
        first = defined.get(material.name)
        if _is_definition(material):
            if not material.is_global:
                names.setdefault(material.name, material)
            if first is not None and material.name not in reported and _differ(material, first):
                reported.add(material.name)
                yield _redefined(material, first)
        elif material.name not in names and material.name not in reported:
            reported.add(material.name)
            more = uses[material.name] - 1
            yield _undefined(sheet, material, first, known, more)


def _definitions(sheet: Sheet) -> dict[str, MaterialEntry]:
    """Of each name the definition that counts: that of the robot, else the first one."""
    found: dict[str, MaterialEntry] = {}
    for material in sheet.materials:
        if material.name and _is_definition(material):
            found.setdefault(material.name, material)
    return found


def _is_definition(material: MaterialEntry) -> bool:
    return material.color_element is not None or material.texture is not None


def _undefined(
    sheet: Sheet,
    material: MaterialEntry,
    later: MaterialEntry | None,
    known: list[str],
    more: int,
) -> Find:
    name = str(material.name)
    times = f" ({more + 1} times)" if more else ""
    color = f'<material name="{shown(name)}"><color rgba="0.75 0.75 0.75 1"/></material>'
    related = []
    if material.is_global:
        what = f"material {quoted(name)} has neither a colour nor a texture"
        remedy = 'Give it one: <color rgba="0.75 0.75 0.75 1"/>.'
    elif later is not None:
        what = f"material {quoted(name)} is defined only further down, in line {later.element.span.line}"
        remedy = "Move its definition up into the robot, before the links."
        related = [(later.element, "it is defined here")]
    else:
        what = f"material {quoted(name)} is not defined{times}"
        remedy = f"{meant(sheet.near(name, known))}Or define it in the robot: {color}."
    return Find(
        Part(material.element, "name"),
        what=what,
        remedy=remedy,
        here=f"As in ROS, {_GREY}.",
        gazebo=f"ROS warns that the material is undefined, and {_GREY}.",
        related=related,
    )


def _differ(material: MaterialEntry, first: MaterialEntry) -> bool:
    """Whether a visual defines a material in another way than the definition that counts."""
    looks = (material.rgba, material.texture)
    is_other = not material.is_global and any(looks)
    return is_other and looks != (first.rgba, first.texture)


def _redefined(material: MaterialEntry, first: MaterialEntry) -> Find:
    old, new = (numbers_text(one.rgba or ()) or "a texture" for one in (first, material))
    return Find(
        material.color_element or material.element,
        element=material.element,
        what=f"material {quoted(material.name)} is defined as {new} here, and as {old} in line {first.element.span.line}",
        remedy="Give the two colours two names, or define the material once, in the robot.",
        both="The first definition counts wherever the material is only named.",
        related=[(first.element, "it is defined here first")],
    )


@rule("URDF-W23", "a colour that is not four numbers from 0 to 1", Severity.WARNING)
def bad_colour(sheet: Sheet) -> Iterator[Find]:
    """A colour that is not four numbers from 0 to 1.

    ROS says `malformed color rgba` and leaves the material without a colour; with three numbers it takes black, without a
    word. Red, green, blue and opacity go from 0 to 1, not to 255: divide by 255. Opacity 1 is solid, 0 is invisible.

    Wrong:

        <color rgba="255 128 0"/>

    Right:

        <color rgba="1 0.502 0 1"/>
    """
    for material in sheet.materials:
        color = material.color_element
        if color is None:
            continue
        written = meant_attribute(color, "rgba", "color")
        trouble, right = _trouble(written)
        if trouble:
            yield _bad(color, written, trouble.format(of=_of(material)), right)


def _of(material: MaterialEntry) -> str:
    return f" in material {quoted(material.name)}" if material.name else ""


def _trouble(written: Attribute | None) -> tuple[str, str]:
    """What is wrong with a colour, with a gap for whose it is, and what would be right."""
    if written is None:
        return "a colour without rgba{of}", _GREY_RGBA
    text = shown(written.value).replace("{", "{{").replace("}", "}}")
    words = [word for word in written.value.split(" ") if word]
    known = [number for word in words if (number := read_number(word)) is not None]
    if len(known) == len(words) == 3:
        return f"rgba={text!r}{{of}} lacks its fourth number, the opacity", _scaled([*known, 1.0])
    if len(known) == len(words) == 4:
        if all(0.0 <= number <= 1.0 for number in known):
            return "", ""
        return f"the numbers of rgba={text!r}{{of}} are not all from 0 to 1", _scaled(known)
    return f"rgba={text!r}{{of}} is not four numbers", _mended(written.value)


def _mended(text: str) -> str:
    """The colour that was meant by something that is not four numbers; grey if that is not clear."""
    right = mended(text, 4) or mended(text, 3)
    numbers = [float(word) for word in (right or "").split()]
    return _scaled([*numbers, 1.0][:4]) if numbers else _GREY_RGBA


def _scaled(numbers: list[float]) -> str:
    """A colour from 0 to 1 for one from 0 to 255, or to 100; of others what is too much is cut off."""
    *colour, opacity = numbers
    top = max(colour)
    full = 1.0 if top <= _MOST_CUT or top > 255.0 else 100.0 if top == 100.0 else 255.0
    opacity = opacity / (255.0 if opacity > 100.0 else 100.0) if opacity > 1.0 else opacity
    scaled = [*(value / full for value in colour), opacity]
    return " ".join(six_digits(round(min(max(value, 0.0), 1.0), 3)) for value in scaled)


def _bad(color: Element, written: Attribute | None, what: str, right: str) -> Find:
    words = [] if written is None else written.value.split()
    numbers = [read_number(word) for word in words]
    is_black = len(words) not in (0, 4) and all(
        number is not None and 0.0 <= number <= 1.0 for number in numbers
    )
    follows = "The colour becomes black." if is_black else "The material gets no colour."
    return Find(
        written or color,
        element=color,
        what=what,
        remedy=f'Write rgba="{right}": red, green, blue, opacity, each from 0 to 1.',
        both=follows,
    )
