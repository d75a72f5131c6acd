"""Numbers and texts of a file as a sentence shows them, how elements are called in it, and what ROS loses."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Iterator

from simkit.diagnostics import Severity
from simkit.diagnostics.table import Loss
from simkit.geometry import Matrix, Vector, matrix_from_rpy
from simkit.urdf.inertia import Body, body_of_shapes, transpose, turned
from simkit.urdf.model import Rgba
from simkit.urdf.placed_shape import PlacedShape
from simkit.urdf.rules.entries import OriginEntry
from simkit.urdf.rules.vocabulary import nearest
from simkit.urdf.urdfdom.numbers import to_double
from simkit.xml import Element

_SHOWN_LETTERS = 60
_SHOWN_DIGITS = 6


def read_number(text: str | None) -> float | None:
    """The number that `text` is, as urdfdom reads it, white space at its ends aside; None if it is none."""
    return None if text is None else to_double(text.strip(" "))


def read_numbers(text: str | None, count: int) -> tuple[float, ...] | None:
    """So many numbers with spaces between them; None if `text` is anything else."""
    words = [] if text is None else [word for word in text.split(" ") if word]
    numbers = [number for word in words[: count + 1] if (number := read_number(word)) is not None]
    return tuple(numbers) if len(words) == len(numbers) == count else None


def read_vector(text: str | None) -> Vector | None:
    """Three numbers."""
    numbers = read_numbers(text, 3)
    return None if numbers is None else (numbers[0], numbers[1], numbers[2])


def read_rgba(text: str | None) -> Rgba | None:
    """Four numbers, of any size."""
    numbers = read_numbers(text, 4)
    return None if numbers is None else (numbers[0], numbers[1], numbers[2], numbers[3])


def six_digits(number: float) -> str:
    """A number for people: six digits, no needless zeros, no `-0`."""
    return f"{number + 0.0:.{_SHOWN_DIGITS}g}".replace("e-0", "e-").replace("e+0", "e")


def numbers_text(numbers: Iterable[float]) -> str:
    """Several numbers for people, as an attribute would hold them."""
    return " ".join(six_digits(number) for number in numbers)


def shown(text: str) -> str:
    """A text of the file for a message: on one line, and not too long."""
    text = " ".join(text[: 4 * _SHOWN_LETTERS].split())
    return text if len(text) <= _SHOWN_LETTERS else text[: _SHOWN_LETTERS - 3] + "..."


_UNITS = {
    **{"m": 1.0, "cm": 0.01, "mm": 0.001},
    **{"kg": 1.0, "g": 0.001, "rad": 1.0, "rads": 1.0, "n": 1.0, "nm": 1.0, "f": 1.0, "m/s": 1.0},
    **{"deg": math.pi / 180, "degrees": math.pi / 180, "°": math.pi / 180, "rad/s": 1.0},
}
_WITH_UNIT = r"([+-]?[0-9.]+(?:[eE][+-]?[0-9]+)?)\s*([a-z°/]{1,8})"
_PI = r"([+-]?)(?:([0-9.]+)\s*\*?\s*)?(?:math\.|m_)?(?:pi|π)(?:\s*/\s*([0-9.]+))?"
_DASHES = str.maketrans({"−": "-", "–": "-", "—": "-", "\u00a0": " ", "\t": " ", "\n": " "})
_LONGEST = 200


def mended(text: str, count: int) -> str | None:
    """So many numbers as they should have been written; None if it is not clear what was meant.

    Args:
        text: What is written.
        count: How many numbers there should be.
    """
    if len(text) > _LONGEST:
        return None
    text = text.translate(_DASHES).strip().strip("()[]{}\"'").strip()
    if count == 1:
        return _one(text)
    for words in (text.split(), re.split(r"[\s,;]+", text.strip(" ,;"))):
        numbers = [number for word in words if (number := _one(word)) is not None]
        if len(numbers) == len(words) == count:
            return " ".join(numbers)
    return None


def _one(word: str) -> str | None:
    word = word.strip().rstrip(",;").lower()
    for candidate in (word, word.replace(",", "."), word.replace("o", "0")):
        if read_number(candidate) is not None:
            return candidate
    return _with_unit(word) or _of_pi(word)


def _with_unit(word: str) -> str | None:
    match = re.fullmatch(_WITH_UNIT, word)
    number = None if match is None else read_number(match[1])
    if match is None or number is None or match[2] not in _UNITS:
        return None
    return six_digits(number * _UNITS[match[2]])


def _of_pi(word: str) -> str | None:
    match = re.fullmatch(_PI, word)
    if match is None:
        return None
    factor, part = read_number(match[2] or "1"), read_number(match[3] or "1")
    if factor is None or not part:
        return None
    return f"{match[1].replace('+', '')}{factor * math.pi / part:.4f}"


_PARTS = ("inertial", "visual", "collision")
_HOLDERS = (*_PARTS, "material", "joint", "link", "robot")


def quoted(name: str | None) -> str:
    """A name of the file in a sentence, not too long."""
    return repr(shown(name or ""))


def listed(names: Iterable[str], most: int = 6) -> str:
    """Some names in a sentence: `'a', 'b', 'c' and 3 more`."""
    known = list(names)
    more = f" and {len(known) - most} more" if len(known) > most else ""
    return ", ".join(quoted(name) for name in known[:most]) + more


def called(element: Element) -> str:
    """An element in a sentence: `joint 'hip'`, `a link without a name`, `the robot`."""
    if element.parent is None:
        return "the robot"
    word = nearest(element.name, _HOLDERS) or shown(element.name)
    name = element.get("name")
    return f"a {word} without a name" if not name else f"{word} {quoted(name)}"


def owner(element: Element) -> Element:
    """The link, joint or material that an element is a part of, or itself if it is none; at last the robot."""
    while element.parent is not None and element.parent.parent is not None:
        element = element.parent
    return element


def part_of(element: Element) -> str:
    """Where an element stands, for a sentence: `the collision of link 'torso'`, `joint 'hip'`."""
    whole = called(owner(element))
    part = next((word for word in _words_up(element) if word in _PARTS), "")
    return f"the {part} of {whole}" if part else whole


def meant(near: Iterable[str]) -> str:
    """`Did you mean 'a' or 'b'? ` of some near names; nothing of none."""
    names = [quoted(name) for name in near]
    return f"Did you mean {' or '.join(names)}? " if names else ""


REFUSED = Loss(
    here="simkit refuses the file too.",
    gazebo="ROS refuses the whole file.",
    severity=Severity.ERROR,
)
"""What follows if ROS refuses the whole file."""


def loss(element: Element) -> Loss:
    """What follows if an element, or something in it, cannot be read.

    Source:
        urdfdom reads of a link the inertial, then the visuals, then the collisions, and stops at the first fault; a fault in a
        joint makes it refuse the file.
    """
    link = called(owner(element))
    here = "simkit loses the same."
    lost = {
        "inertial": f"ROS stops reading {link} here: its mass, all its visuals and all its collisions are lost, and yet "
        "the file is accepted.",
        "visual": f"ROS stops reading {link} here: this visual, those after it and all its collisions are lost, and yet "
        "the file is accepted.",
        "collision": f"ROS stops reading {link} here: this collision and those after it are lost, and yet the file is "
        "accepted.",
    }
    holder = _holder(element)
    if holder in lost:
        return Loss(severity=Severity.ERROR, here=here, gazebo=lost[holder])
    if holder == "material":
        return Loss(
            severity=Severity.WARNING, here=here, gazebo="ROS goes on without this material."
        )
    return REFUSED


def _words_up(element: Element | None) -> Iterator[str | None]:
    """The words of `_HOLDERS` that an element and those around it are, from the inside."""
    while element is not None:
        yield nearest(element.name, _HOLDERS)
        element = element.parent


def _holder(element: Element) -> str:
    """Which word of `_HOLDERS` holds an element.

    A visual goes without a material whose colour is faulty; a fault of the material itself costs the visual.
    """
    step: Element | None = element
    while step is not None:
        word = nearest(step.name, _HOLDERS)
        is_whole = step is element and step.parent is not None and step.parent.parent is not None
        if word is not None and not (word == "material" and is_whole):
            return word
        step = step.parent
    return "robot"


_STILL = 1e-6
"An entry of a tensor that is a smaller share of the largest one is shown as 0."


def tensor_text(tensor: Matrix) -> str:
    """A tensor as an element to paste, with four digits."""
    (ixx, ixy, ixz), (_, iyy, iyz), (_, _, izz) = tensor
    small = _STILL * max(abs(ixx), abs(iyy), abs(izz))
    named = {"ixx": ixx, "ixy": ixy, "ixz": ixz, "iyy": iyy, "iyz": iyz, "izz": izz}
    texts = [
        f'{name}="{four_digits(0.0 if abs(value) < small else value)}"'
        for name, value in named.items()
    ]
    return f"<inertia {' '.join(texts)}/>"


def inertial_text(shapes: tuple[PlacedShape, ...], origin: OriginEntry | None, mass: float) -> str:
    """An `<inertial>` to paste for a link that has none.

    Args:
        shapes: What the mass fills, in the frame of the link.
        origin: The `<origin>` of the shape if it is only one: then the tensor is written in its axes.
        mass: Mass [kg].
    """
    body = body_of_shapes(shapes, mass)
    rpy: Vector = (0.0, 0.0, 0.0)
    if origin is not None and origin.rpy is not None:
        rpy = origin.rpy
        body = Body(mass, body.centre, turned(body.tensor, transpose(matrix_from_rpy(rpy))))
    where = f'<origin xyz="{triple(body.centre)}" rpy="{triple(rpy)}"/>'
    return (
        f'<inertial>{where}<mass value="{four_digits(mass)}"/>{tensor_text(body.tensor)}</inertial>'
    )


def four_digits(number: float) -> str:
    """A number with four digits."""
    text = f"{number:.4g}"
    return "0" if float(text) == 0.0 else text


def triple(vector: Vector) -> str:
    """Three numbers as an attribute holds them, right angles too; what is next to nothing is 0."""
    return " ".join(f"{0.0 if abs(value) < 1e-12 else value:.7g}" for value in vector)
