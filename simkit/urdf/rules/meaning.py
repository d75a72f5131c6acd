"""What a misspelt word was meant to be, so that one slip of the pen is one find and not five.

`<inertail>` is read as `<inertial>` by every rule; the rule of unknown words alone complains of it.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache
from itertools import islice

from simkit.urdf.rules.vocabulary import WORDS
from simkit.xml import Attribute, Element

OTHER_NAMES = {
    **{("mass", name): "value" for name in ("mass", "val", "kg")},
    **{("limit", name): "lower" for name in ("min", "low")},
    **{("limit", name): "upper" for name in ("max", "high")},
    **{("limit", name): "effort" for name in ("torque", "force")},
    **{("limit", name): "velocity" for name in ("speed", "vel")},
    **{(role, name): "link" for role in ("parent", "child") for name in ("name", "frame")},
    **{("cylinder", name): "length" for name in ("height", "h", "len")},
    **{("origin", name): "xyz" for name in ("position", "pos")},
    **{("origin", name): "rpy" for name in ("rotation", "orientation", "rot")},
    **{("box", name): "size" for name in ("dimensions", "dim", "dims", "xyz")},
    **{(shape, "r"): "radius" for shape in ("cylinder", "sphere")},
    **{("mesh", name): "filename" for name in ("file", "uri", "url", "path")},
    **{("color", name): "rgba" for name in ("rgb", "value", "color")},
}
"""Attributes that people write, by element, and the one that they mean."""
_ALIKE = 0.7
"""From this similarity on, of 1, a word passes for a misspelt one."""
_LONGEST = 40
"""Longer words are no slip of the pen; comparing them would take time [letters]."""
_MOST = 40
"""So many unknown attributes of an element are compared with what may stand there; nobody misspells more of them."""


@lru_cache(maxsize=1024)
def nearest(written: str, words: tuple[str, ...]) -> str | None:
    """The word of `words` that `written` looks like, whatever its capitals; None if it looks like none."""
    if written in words:
        return written
    if len(written) > _LONGEST:
        return None
    import difflib  # only a file with a fault needs it

    folded = {word.lower(): word for word in words}
    found = difflib.get_close_matches(written.lower(), folded, n=1, cutoff=_ALIKE)
    # Of `xzy` and `xyz` too few letters agree, but two that changed places are the commonest slip.
    found = found or [word for word in folded if sorted(word) == sorted(written.lower())]
    return folded[found[0]] if found else None


def meant_word(element: Element, words: tuple[str, ...]) -> str | None:
    """Which of the words that may stand here an element is meant to be.

    Args:
        element: Any element.
        words: Names of the elements that may stand where it stands.

    Returns:
        Its own name if that may stand here, else the one that it looks like. A word that URDF knows from another place counts
        as misspelt only if what it holds fits the other word.
    """
    if element.name in words:
        return element.name
    near = None if ":" in element.name else nearest(element.name, words)
    if near is None or element.name not in WORDS:
        return near
    word = WORDS[near]
    fits = any(element.attribute(name) for name in word.attributes)
    return near if fits or any(element.child(name) for name in word.children) else None


def meant_children(element: Element, context: str) -> dict[str, list[Element]]:
    """The children of an element by the word that each is meant to be, misspelt ones behind the right ones.

    Args:
        element: The element.
        context: The word that the element itself is meant to be.
    """
    words = WORDS[context].children
    found: dict[str, list[Element]] = {word: [] for word in words}
    misspelt: list[tuple[str, Element]] = []
    for child in element.children:
        if child.name in found:
            found[child.name].append(child)
        elif (word := meant_word(child, words)) is not None:
            misspelt.append((word, child))
    for word, child in misspelt:
        found[word].append(child)
    return found


def meant_attribute(element: Element, name: str, context: str) -> Attribute | None:
    """The attribute `name` of an element, or a misspelt one that looks like it; None if there is neither."""
    exact = element.attribute(name)
    if exact is not None:
        return exact
    return next((one for one, word in misspelt_attributes(element, context) if word == name), None)


def misspelt_attributes(element: Element, context: str) -> list[tuple[Attribute, str]]:
    """The unknown attributes of an element that look like ones it lacks, each with the one that it looks like.

    Args:
        element: The element.
        context: The word that the element itself is meant to be.
    """
    known = WORDS[context].attributes
    missing = tuple(one for one in known if element.attribute(one) is None)
    unknown = (one for one in element.attributes if one.name not in known)
    meant: dict[str, Attribute] = {}
    for one in islice(unknown, _MOST):
        word = OTHER_NAMES.get((context, one.name)) or nearest(one.name, missing)
        if word in missing:
            meant.setdefault(word, one)
    return [(one, word) for word, one in meant.items()]


def first(elements: Iterable[Element]) -> Element | None:
    """The first of some elements; None if there are none."""
    return next(iter(elements), None)
