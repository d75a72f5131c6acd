"""What to tell a learner whose lookup failed: what exists, by how much it missed, what to do."""

from __future__ import annotations

from simkit.errors import near_names
from simkit.tf import trees
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
            return trees.two_trees_hint(core, target, source)
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
    loop = trees.find_loop(core)
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
