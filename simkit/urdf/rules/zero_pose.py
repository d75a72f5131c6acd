"""Where the links of a file stand when all its joints are at 0, as far as that can be read."""

from __future__ import annotations

from dataclasses import dataclass

from simkit.urdf.frame import Frame
from simkit.urdf.placed_shape import PlacedShape
from simkit.urdf.rules.bodies import frame_of, shapes_of
from simkit.urdf.rules.entries import BodyEntry
from simkit.urdf.rules.sheet import Sheet


@dataclass(frozen=True)
class Standing:
    """Where a link stands."""

    root: str
    """The root link that it hangs on, over however many joints."""
    frame: Frame
    """Its frame, seen from that root."""


def zero_pose(sheet: Sheet) -> dict[str, Standing]:
    """The links that hang together with a root, and where they stand, by name."""
    found: dict[str, Standing] = {}
    waiting = [
        (name, Standing(name, Frame()))
        for name in sheet.link_by_name
        if name not in sheet.joints_above
    ]
    while waiting:
        name, standing = waiting.pop()
        if name in found:
            continue
        found[name] = standing
        for joint in sheet.joints_below.get(name, ()):
            frame = frame_of(joint.origin)
            if frame is not None and joint.child in sheet.link_by_name and joint.child:
                below = Standing(standing.root, standing.frame.then(frame))
                waiting.append((joint.child, below))
    return found


def standing_shapes(
    bodies: tuple[BodyEntry, ...], standing: Standing | None
) -> tuple[PlacedShape, ...]:
    """The simple shapes among some visuals or collisions of a link, seen from its root."""
    if standing is None:
        return ()
    return tuple(shape.seen_from(standing.frame) for shape in shapes_of(bodies))
