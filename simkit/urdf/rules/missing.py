"""Which attributes an element lacks, and what it should hold: taken from where somebody wrote it instead."""

from __future__ import annotations

from simkit.urdf.rules.meaning import meant_attribute
from simkit.urdf.rules.number_repair import mended
from simkit.urdf.rules.values import number_text, read_number, shown
from simkit.urdf.rules.vocabulary import WORDS
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
    """Attributes that an element must have and has not, not even misspelt; names are told of by another rule."""
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
        return None if diameter is None else number_text(diameter / 2)
    inner = element.child(name)
    text = inner.text if inner is not None else element.text if only else ""
    text = " ".join(text[:200].split())
    if not text:
        return None
    count = 3 if name in _VECTORS else 1
    return mended(text, count) or shown(text)
