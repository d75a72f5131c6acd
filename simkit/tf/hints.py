"""Hints for a learner whose lookup failed: what exists, by how much it missed, what to do."""

from __future__ import annotations

import re

from simkit.errors import near_names
from simkit.tf.buffer_core import BufferCore
from simkit.tf.errors import (
    ConnectivityException,
    DataGap,
    ExtrapolationException,
    InvalidArgumentException,
    LookupException,
    TransformException,
)

_TWO_CLOCKS = 10**15
"Stamps further apart than this [ns], 10^6 s, come from two clocks."

_SHOWN = 12
"So many known frames are named."

_COMPARED = 200
"So many names are searched for a near one: whoever broadcasts thousands must not slow a lookup."


def teach(error: TransformException, core: BufferCore) -> None:
    """Give an error its hint, also as a note, which every traceback of Python ends with.

    Args:
        error: What a lookup raised.
        core: The buffer that it was raised by, still in the same state.
    """
    attach(error, hint_for(error, core))


def attach(error: TransformException, hint: str) -> None:
    """Give an error a hint that is known; an empty one changes nothing."""
    if hint and hint != error.hint:
        error.hint = hint
        error.add_note(f"hint: {hint}")


def hint_for(error: TransformException, core: BufferCore) -> str:
    """One or two sentences for a failed lookup; empty if there is nothing to teach.

    Args:
        error: What the lookup raised.
        core: The buffer that it was raised by, still in the same state.
    """
    match error:
        case InvalidArgumentException(frame=str(frame)):
            return _bad_name(frame)
        case LookupException(frame=str(frame)):
            return _unknown_name(frame, core)
        case LookupException():
            return _loop(core)
        case ConnectivityException(frames=(target, source)):
            return two_trees_hint(core, target, source)
        case ExtrapolationException(gap=DataGap() as gap):
            return _gap(gap, core)
        case ExtrapolationException():
            return "The buffer was cleared, as the clock jumped back: wait for new transforms."
        case _:
            return ""


def _bad_name(frame: str) -> str:
    if not frame:
        return "A frame needs a name; an empty one often comes from a message without frame_id."
    return f'Write "{frame.lstrip("/")}": tf2 takes frame names without the slash that tf allowed.'


def _unknown_name(frame: str, core: BufferCore) -> str:
    known = core.frame_strings
    if not known:
        return (
            "No transform has arrived yet. Is a broadcaster running? "
            "A new listener needs about 0.1 s to hear it."
        )
    near = " or ".join(f'"{name}"' for name in near_names(frame, known[:_COMPARED]))
    shown = ", ".join(sorted(known)[:_SHOWN])
    more = f" and {len(known) - _SHOWN} more" if len(known) > _SHOWN else ""
    question = f"Did you mean {near}? Or is" if near else "Is"
    return (
        f'No transform named the frame "{frame}" so far; known: {shown}{more}. '
        f"{question} the node that broadcasts it not running yet?"
    )


def _loop(core: BufferCore) -> str:
    loop = frames_in_loop(core)
    if not loop:
        return ""
    return (
        f'"{loop[0]}" is its own ancestor: {" -> ".join([*loop, loop[0]])} (child -> parent). '
        "Two broadcasters disagree on which of them is the parent."
    )


def _gap(gap: DataGap, core: BufferCore) -> str:
    if abs(gap.missing) > _TWO_CLOCKS:
        return (
            f'You ask for t = {_sec(gap.requested)} s, but "{gap.frame}" is known at '
            f"t = {_sec(gap.newest)} s: one stamp is wall-clock time, the other simulated time. "
            "Take all stamps from rospy.Time.now()."
        )
    if gap.missing > 0:
        return (
            f'The newest transform of "{gap.frame}" is {_sec(gap.missing)} s older than the time '
            "you ask for: data always arrives a little later. Ask for rospy.Time(0), the latest, "
            "or wait: waitForTransform in tf, a timeout in tf2."
        )
    return (
        f'The buffer knows "{gap.frame}" from t = {_sec(gap.oldest)} s to {_sec(gap.newest)} s; '
        f"you ask for {_sec(-gap.missing)} s before that. Wait until it reaches back so far, or "
        f"ask for a later time; after {core.cache_time / 1e9:g} s it forgets."
    )


def _sec(nanoseconds: int) -> str:
    return f"{nanoseconds / 1e9:.3f}"


_ALIKE = 0.8
"Least similarity of two spellings of one name."

_SHOWN_OF_TREE = 8
"So many members of a tree are named."


def trees(core: BufferCore) -> dict[str, list[str]]:
    """Members of each tree by the tree's root, root first; a loop has no root and is left out."""
    members: dict[str, list[str]] = {}
    for frame, root in _roots(core).items():
        if root is not None:
            group = members.setdefault(root, [root])
            if frame != root:
                group.append(frame)
    return members


def frames_in_loop(core: BufferCore) -> list[str]:
    """Frames of a loop, each followed by its parent; empty if there is none."""
    start = next((frame for frame, root in _roots(core).items() if root is None), None)
    passed: dict[str, None] = {}
    while start is not None and start not in passed:
        passed[start] = None
        start = core.parent_of(start)
    way = list(passed)
    return way[way.index(start) :] if start is not None else []


def two_trees_hint(core: BufferCore, target: str, source: str) -> str:
    """Names the two trees that frames lie in, and the transform that may be missing."""
    roots, all_trees = _roots(core), trees(core)
    a, b = (all_trees.get(roots.get(frame) or "", []) for frame in (target, source))
    if not a or not b:
        return ""
    return f"There are two trees: {_named(a)}, and {_named(b)}. {_remedy(a, b)}"


def _roots(core: BufferCore) -> dict[str, str | None]:
    """Root of each frame; None for one whose way up never ends."""
    roots: dict[str, str | None] = {}
    for start in core.frame_strings:
        way: dict[str, None] = {}
        frame, parent = start, core.parent_of(start)
        while frame not in roots and frame not in way and parent is not None:
            way[frame] = None
            frame, parent = parent, core.parent_of(parent)
        end = roots.get(frame, None if frame in way else frame)
        roots[frame] = end
        roots.update(dict.fromkeys(way, end))
    return {frame: roots[frame] for frame in core.frame_strings}


def _named(tree: list[str]) -> str:
    root, *rest = tree
    shown = ", ".join(sorted(rest)[:_SHOWN_OF_TREE])
    more = f" and {len(rest) - _SHOWN_OF_TREE} more" if len(rest) > _SHOWN_OF_TREE else ""
    return f'"{root}" with {shown}{more}' if rest else f'"{root}" alone'


def _remedy(a: list[str], b: list[str]) -> str:
    for tree, other in ((a, b), (b, a)):
        for name in other[:_COMPARED]:
            if _spelled_alike(tree[0], name):
                return f'The parent "{tree[0]}" may be a misspelt "{name}".'
    parent, child = (a[0], b[0]) if len(a) >= len(b) else (b[0], a[0])
    return f'No transform joins them; a broadcast with parent "{parent}" and child "{child}" would.'


def _spelled_alike(one: str, other: str) -> bool:
    """Whether two names differ by a slip, and not by their number."""
    if re.findall(r"\d+", one) != re.findall(r"\d+", other):
        return False
    import difflib  # only who has made a mistake waits for it

    folded = difflib.SequenceMatcher(None, one.lower(), other.lower())
    return folded.ratio() >= _ALIKE
