"""Reading an SDF file: its elements as values, and what is wrong with them, with its place."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass, field

from simkit.diagnostics import Diagnostic, Severity
from simkit.errors import near_names
from simkit.geometry import Vector
from simkit.physics.errors import WorldFileError
from simkit.physics.plan import LARGEST
from simkit.physics.sdf.library import ModelLibrary
from simkit.physics.sdf.rules import NUMBER, UNSUPPORTED, UNUSABLE
from simkit.urdf.fixed_joints import TRUE
from simkit.urdf.model import Pose, Rgba
from simkit.xml import Document, Element


@dataclass(slots=True, kw_only=True)
class Page:
    """One file, while it is read."""

    document: Document
    """The file."""
    version: tuple[int, int]
    """Of SDF, e.g. (1, 6)."""
    library: ModelLibrary
    """Where included models are found."""
    found: list[Diagnostic] = field(default_factory=list)
    """What is wrong; one list for a world and all that it includes."""
    depth: int = 0
    """How many files include this one."""

    def say(
        self,
        element: Element,
        what: str,
        remedy: str,
        *,
        severity: Severity = Severity.WARNING,
        rule: str = UNSUPPORTED,
    ) -> Diagnostic:
        """Note what is wrong with an element.

        Args:
            element: The element.
            what: What is wrong; no full stop.
            remedy: What would be right.
            severity: How bad it is.
            rule: Id of the kind of fault.
        """
        diagnostic = Diagnostic(
            rule=rule,
            severity=severity,
            file=self.document.file,
            span=element.span,
            source=self.document.line(element.span.line),
            path=element.path,
            what=what,
            remedy=remedy,
        )
        self.found.append(diagnostic)
        return diagnostic

    def refuse(self, element: Element, what: str, remedy: str) -> WorldFileError:
        """The error for something without which the file cannot be used."""
        one = self.say(element, what, remedy, severity=Severity.ERROR, rule=UNUSABLE)
        place = f"{one.file}:{one.span.line}:{one.span.column}"
        return WorldFileError(f"{place}: {what}; {remedy}", self.found)

    def leave_out(
        self, element: Element, known: Iterable[str], *, silent: Iterable[str] = ()
    ) -> None:
        """Name what is in an element and is not read.

        Args:
            element: The element.
            known: Names that are read.
            silent: Names that change nothing here, of which nothing need be said.
        """
        names = [*known, *silent]
        for child in element.children:
            if child.name in names or ":" in child.name:
                continue
            near = near_names(child.name, names, limit=1)
            meant = f"Did you mean <{near[0]}>?" if near else "Leave it out; nothing reads it here."
            self.say(child, f"<{child.name}> in a <{element.name}> is not supported", meant)

    def text(self, element: Element, name: str, default: str = "") -> str:
        """The text of a child; the default if there is no such child."""
        child = element.child(name)
        return default if child is None else child.text.strip()

    def flag(self, element: Element, name: str, *, default: bool = False) -> bool:
        """Whether a child says true."""
        child = element.child(name)
        return default if child is None else child.text.strip().lower() in TRUE

    def number(self, element: Element, name: str, default: float) -> float:
        """The number in a child; the default, with a warning, if it is not one."""
        found = self.numbers(element, name, 1)
        return default if found is None else found[0]

    def numbers(self, element: Element, name: str, count: int) -> tuple[float, ...] | None:
        """So many numbers in a child; None, with a warning if they are wrong, without them."""
        child = element.child(name)
        if child is None:
            return None
        try:
            values = tuple(float(word) for word in child.text.split())
        except ValueError:
            values = ()
        if len(values) == count and not any(map(_is_wild, values)):
            return values
        kind = "a number" if count == 1 else f"{count} numbers"
        self.say(
            child,
            f"<{name}> is {child.text.strip()!r}, not {kind}",
            f"Write {kind}.",
            rule=NUMBER,
        )
        return None

    def vector(self, element: Element, name: str, default: Vector) -> Vector:
        """Three numbers in a child, or the default."""
        found = self.numbers(element, name, 3)
        return default if found is None else (found[0], found[1], found[2])

    def colour(self, element: Element, name: str) -> Rgba | None:
        """A colour in a child, with or without opacity; None if there is none."""
        child = element.child(name)
        if child is None:
            return None
        count = 3 if len(child.text.split()) == 3 else 4
        found = self.numbers(element, name, count)
        if found is None:
            return None
        return (found[0], found[1], found[2], found[3] if count == 4 else 1.0)

    def pose(self, element: Element) -> Pose:
        """The `<pose>` of an element; its own frame if it has none."""
        child = element.child("pose")
        if child is None or not child.text.strip():
            return Pose()
        frame = child.get("relative_to") or child.get("frame") or ""
        if frame:
            self.say(
                child,
                f"the pose of {element.get('name')} is given relative to {frame!r}, which is not supported",
                "Give it relative to what the element stands in.",
            )
        found = self.numbers(element, "pose", 6)
        if found is None:
            return Pose()
        return Pose((found[0], found[1], found[2]), (found[3], found[4], found[5]))


def _is_wild(value: float) -> bool:
    """Whether a number is NaN, or larger than anything in a world; infinity is a limit."""
    return math.isnan(value) or (abs(value) > LARGEST and abs(value) < 1e15)
