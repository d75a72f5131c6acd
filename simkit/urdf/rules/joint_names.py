"""Names of the joints that move, for sentences that advise one of them."""

from __future__ import annotations

from collections.abc import Sequence

from simkit.urdf.rules.sheet import Sheet
from simkit.urdf.rules.wording import listed, meant

_SHOWN = 8


def moving_joints(sheet: Sheet) -> list[str]:
    """The joints that one number moves, in the order of the file."""
    return [joint.name for joint in sheet.joints if joint.moves and joint.name]


def joint_advice(sheet: Sheet, name: str, moving: Sequence[str]) -> str:
    """Which joint may be meant, or which ones there are."""
    return meant(sheet.near(name, moving)).strip() or known_names("joints that move", moving)


def known_names(kind: str, names: Sequence[str]) -> str:
    """What there is of a kind, in a sentence."""
    more = f", and {len(names) - _SHOWN} more" if len(names) > _SHOWN else ""
    return (
        f"There are the {kind}: {listed(names[:_SHOWN])}{more}."
        if names
        else f"There are no {kind}."
    )
