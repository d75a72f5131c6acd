"""Tasks with numbers of one's own: the same name gives the same numbers, another name others."""

from __future__ import annotations

import hashlib
import random
from dataclasses import dataclass
from typing import Final

from grader.checks.answers import given_answer
from grader.errors import CheckFailed
from grader.submission import Submission

_COLOURS: Final = {
    "orange": (1.0, 0.5, 0.0),
    "teal": (0.0, 0.5, 0.5),
    "violet": (0.5, 0.25, 0.75),
    "yellow": (1.0, 0.85, 0.1),
    "dark red": (0.6, 0.1, 0.1),
    "sky blue": (0.4, 0.7, 1.0),
    "olive": (0.5, 0.5, 0.1),
    "pink": (1.0, 0.6, 0.75),
}


@dataclass(frozen=True, slots=True, kw_only=True)
class BaseTask:
    """The base that one student is to build."""

    radius: float
    """Radius of the cylinder [m]."""
    length: float
    """Length of the cylinder [m]."""
    colour: str
    """Name of its colour, for people."""
    rgba: tuple[float, float, float, float]
    """The same as red, green, blue and opacity, from 0 to 1."""

    def __repr__(self) -> str:
        return (
            f"a cylinder with radius {self.radius:g} m and length {self.length:g} m, in {self.colour}: "
            f"rgba {' '.join(f'{part:g}' for part in self.rgba)}"
        )


def base_of(student: str) -> BaseTask:
    """The base of a student in exercise 3.6.

    Args:
        student: Their name; capital letters and blanks around it do not matter.
    """
    rng = _generator("3.6", student)
    colour = rng.choice(sorted(_COLOURS))
    return BaseTask(
        radius=rng.randrange(12, 21) / 100,
        length=rng.choice((0.03, 0.04, 0.06, 0.07, 0.08)),
        colour=colour,
        rgba=(*_COLOURS[colour], 1.0),
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class PoseTask:
    """The pose in which one student is to predict where an arm's tip is."""

    hip: float
    """Angle of the hip [rad]."""
    shoulder: float
    """Angle of the shoulder [rad]."""

    def __repr__(self) -> str:
        return f"the hip at {self.hip:g} rad, the shoulder at {self.shoulder:g} rad"


def pose_of(student: str) -> PoseTask:
    """The pose of a student in exercise 3.8.

    Args:
        student: Their name; capital letters and blanks around it do not matter.
    """
    rng = _generator("3.8/pose", student)
    return PoseTask(
        hip=rng.choice((-1, 1)) * rng.randrange(40, 130) / 100,
        shoulder=rng.choice((-1, 1)) * rng.randrange(40, 110) / 100,
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class CrateTask:
    """The crate that one student puts into their world."""

    size: tuple[float, float, float]
    """Lengths along x, y, z [m]."""
    mass: float
    """[kg]."""
    x: float
    """How far ahead of the origin its middle stands [m]; it stands at y = 0."""

    def __repr__(self) -> str:
        x, y, z = self.size
        return (
            f"a crate of {x:g} m (along x) by {y:g} m (along y) by {z:g} m (along z), {self.mass:g} kg, "
            f"that stands on the ground with its middle at x = {self.x:g} m, y = 0"
        )


def crate_of(student: str) -> CrateTask:
    """The crate of a student in exercise S.2.

    Args:
        student: Their name; capital letters and blanks around it do not matter.
    """
    rng = _generator("S.2", student)
    x, y, z = rng.sample((0.26, 0.3, 0.34, 0.38, 0.42, 0.46), 3)
    return CrateTask(
        size=(x, y, z),
        mass=rng.choice((0.8, 1.2, 1.6, 2.2, 2.8)),
        x=rng.randrange(12, 21) / 10,
    )


def name_of(submission: Submission, answer: str) -> str:
    """The name that a student gave as an answer.

    Args:
        submission: What was handed in.
        answer: Name of the answer, e.g. `student`.

    Raises:
        CheckFailed: There is none.
    """
    name = given_answer(submission, answer)
    if not isinstance(name, str) or not any(map(str.isalpha, name)):
        raise CheckFailed(
            f"{answer} is not a name", hint=f'Write your name in quotes: {answer} = "Ada Lovelace".'
        )
    return name


def _generator(exercise: str, student: str) -> random.Random:
    text = f"{exercise}/{_folded(student)}"
    return random.Random(hashlib.sha256(text.encode("utf-8", "replace")).digest())


def _folded(name: str) -> str:
    return " ".join(name.casefold().split())
