"""What changes from moment to moment in a world: contacts, and what lasers see."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Iterator
from typing import Any, Final

from simkit.geometry import Vector
from simkit.physics import Contact
from simkit.viz.marks import Marks, Polyline
from simkit.viz.world.scene import Actor
from simkit.viz.world.things import Thing

CONTACTS: Final = "contacts"
"""Name of the display of contacts."""
SCANS: Final = "scans"
"""Name of the display of what lasers see."""
_CONTACT_COLOR, _SCAN_COLOR = "#0a8f45", "#1f5fe0"
_LONGEST: Final = 1.5
"Longest arrow of a force, in lengths of the arrow for the weight of the heaviest model."
_BARB, _BARB_WIDTH = 0.16, 0.07
"Length and half the width of the head of an arrow, in lengths of the arrow."


class ForceScale:
    """How long the arrow of a force is: that of the weight of the heaviest model is as long as that model.

    Args:
        actors: The models.
        gravity: Acceleration of all that falls [m/s^2].
    """

    def __init__(self, actors: Collection[Actor], gravity: Vector) -> None:
        loose = [one for one in actors if not one.model.plan.is_static and one.size > 0.0]
        heaviest = max(loose, key=lambda one: one.model.mass, default=None)
        self._fixed = {one.model.name for one in actors if one.model.plan.is_static}
        self._length = 1.0 if heaviest is None else heaviest.size
        pull = math.hypot(*gravity) or 9.8
        self._weight = (heaviest.model.mass * pull if heaviest is not None else 0.0) or 1.0

    def felt(self, contact: Contact) -> Iterator[Polyline]:
        """An arrow for the force on the one of two models that can move; on the first if both can."""
        x, y, z = contact.force
        is_other = contact.first.model in self._fixed
        yield from self.arrow(contact.point, (-x, -y, -z) if is_other else (x, y, z))

    def arrow(self, start: Vector, force: Vector) -> Iterator[Polyline]:
        """An arrow for a force [N] that acts at a point of the world [m]."""
        strength = math.hypot(*force)
        length = min(strength / self._weight, _LONGEST) * self._length
        if length < 1e-4 * self._length:
            return
        unit = (force[0] / strength, force[1] / strength, force[2] / strength)
        tip = _along(start, unit, length)
        yield (start, tip)
        back = _along(start, unit, (1.0 - _BARB) * length)
        for side in _across(unit):
            yield (tip, _along(back, side, _BARB_WIDTH * length))


def contact_marks(contacts: Iterable[Contact], scale: ForceScale, *, is_on: bool) -> Marks:
    """Where models touch, with arrows for the forces in the last step.

    Args:
        contacts: Where they touch.
        scale: How long arrows are.
        is_on: Whether they are seen at first.
    """
    found = list(contacts)
    return Marks(
        name=CONTACTS,
        label="Contacts",
        color=_CONTACT_COLOR,
        points=tuple(one.point for one in found),
        lines=tuple(line for one in found for line in scale.felt(one)),
        is_on=is_on,
        shines_through=True,
    )


def laser_marks(points: Iterable[Vector], *, is_on: bool) -> Marks:
    """What lasers see.

    Args:
        points: Where their beams end [m].
        is_on: Whether it is seen at first.
    """
    return Marks(name=SCANS, label="Laser", color=_SCAN_COLOR, points=tuple(points), is_on=is_on)


def scan_points(things: Iterable[Thing]) -> tuple[Vector, ...]:
    """Where the beams of all lasers end in the world [m]; nothing for beams that hit nothing."""
    plugins: list[Any] = [plugin for one in things for plugin in one.plugins]
    return tuple(
        (x, y, z)
        for plugin in plugins
        if hasattr(plugin, "scan_points")
        for x, y, z in plugin.scan_points().points.tolist()
        if math.isfinite(x + y + z)
    )


def _along(start: Vector, direction: Vector, length: float) -> Vector:
    x, y, z = (s + length * d for s, d in zip(start, direction, strict=True))
    return (x, y, z)


def _across(unit: Vector) -> tuple[Vector, ...]:
    """Four directions across one of unit length."""
    x, y, z = unit
    across = (-y, x, 0.0) if abs(z) < 0.9 else (0.0, -z, y)
    length = math.hypot(*across)
    a, b, c = (value / length for value in across)
    d, e, f = y * c - z * b, z * a - x * c, x * b - y * a
    return ((a, b, c), (-a, -b, -c), (d, e, f), (-d, -e, -f))
