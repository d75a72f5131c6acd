"""Where every frame is, seen from one of them: what a view of tf in space shows."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass

from simkit.errors import near_names
from simkit.geometry import Quaternion, Transform, Vector, rotate
from simkit.msgs import Time
from simkit.tf import (
    LATEST,
    Buffer,
    BufferCore,
    ConnectivityException,
    ExtrapolationException,
    TransformException,
)
from simkit.viz.trees.forest import forest_of

_AXES: tuple[Vector, Vector, Vector] = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
_FAR = 1e12
"Nothing is drawn beyond this distance [m]."
_COMPARED = 200
"So many names are searched for a near one."


@dataclass(frozen=True, slots=True, kw_only=True)
class FramePose:
    """A frame seen from the fixed frame."""

    name: str
    """The frame."""
    parent: str | None
    """Its parent; None for a root."""
    origin: Vector
    """Where its origin is [m]."""
    rotation: Quaternion
    """How it is turned, xyzw, of unit length."""

    @property
    def axes(self) -> tuple[Vector, Vector, Vector]:
        """Directions of its x, y and z, of unit length."""
        x, y, z = (rotate(self.rotation, axis) for axis in _AXES)
        return (x, y, z)


@dataclass(frozen=True, slots=True, kw_only=True)
class TfScene:
    """All frames at one moment."""

    fixed_frame: str
    """The frame that all others are seen from."""
    poses: tuple[FramePose, ...]
    """The frames that are connected to it, a parent before its children."""
    error: str
    """Why nothing can be shown; empty if something can."""
    problems: tuple[str, ...]
    """A sentence for each frame, or message, that cannot be shown."""


def tf_scene(
    buffer: Buffer, *, fixed_frame: str, time: Time = LATEST, troubles: Iterable[str] = ()
) -> TfScene:
    """Where every frame of a buffer is.

    Args:
        buffer: The transforms.
        fixed_frame: The frame that all others are seen from.
        time: When; for each frame its own latest time if `Time(0)`.
        troubles: Sentences on what else needs the transforms, and cannot be shown.

    Source:
        RViz' TF display, with its words for what is wrong.
    """
    core = buffer.core
    if not core.frame_exists(fixed_frame):
        return TfScene(
            fixed_frame=fixed_frame,
            poses=(),
            error=_no_such_frame(core, fixed_frame),
            problems=tuple(troubles),
        )
    poses: list[FramePose] = []
    problems: list[str] = []
    names = (node.name for tree in forest_of(core).trees for node in tree.nodes if not node.is_echo)
    for name in names:
        try:
            found = core.lookup(fixed_frame, name, time=time.to_nsec())
        except TransformException as error:
            reason = _reason(error, time)
            problems.append(f"No transform from [{name}] to [{fixed_frame}]: {reason}")
            continue
        pose = _pose(name, core.parent_of(name, time=time.to_nsec()), found.transform)
        if pose is None:
            problems.append(f"No transform from [{name}] to [{fixed_frame}]: it is too far away.")
        else:
            poses.append(pose)
    return TfScene(
        fixed_frame=fixed_frame, poses=tuple(poses), error="", problems=(*problems, *troubles)
    )


def _pose(name: str, parent: str | None, found: Transform) -> FramePose | None:
    length = math.sqrt(math.fsum(c * c for c in found.rotation))
    # Written so that "not a number" is too far as well.
    if not (max(map(abs, found.translation)) < _FAR and 0.0 < length < _FAR):
        return None
    x, y, z, w = (component / length for component in found.rotation)
    return FramePose(name=name, parent=parent, origin=found.translation, rotation=(x, y, z, w))


def _no_such_frame(core: BufferCore, frame: str) -> str:
    known = core.frame_strings
    text = f"Fixed Frame [{frame}] does not exist"
    if not known:
        return f"No tf data.  Actual error: {text}"
    near = " or ".join(f"[{name}]" for name in near_names(frame, known[:_COMPARED]))
    shown = ", ".join(f"[{name}]" for name in sorted(known)[:12])
    more = f" and {len(known) - 12} more" if len(known) > 12 else ""
    question = f" Did you mean {near}?" if near else ""
    return f"{text}.{question} Frames: {shown}{more}."


def _reason(error: TransformException, time: Time) -> str:
    match error:
        case ConnectivityException():
            return "they are in two trees."
        case ExtrapolationException():
            return (
                "no data at that time." if time else "no time for which all on the way have data."
            )
        case _:
            return "the way goes round in a loop."
