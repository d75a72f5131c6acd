"""What checks expect of frames: that one is broadcast under its parent, and how far it lies behind the clock."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from grader.checks.expect import expect
from oracles.turtles import HeardTransform
from simkit import Simulation

SEND = "sendTransform(translation, rotation, time, child, parent)"


def expect_frame(
    heard: Sequence[HeardTransform], *, child: str, parent: str, given: Collection[str] = ()
) -> list[HeardTransform]:
    """Expect one frame, and no other, to be broadcast under its parent.

    Args:
        heard: All transforms that were heard.
        child: The frame.
        parent: The frame that it is attached to.
        given: Frames that the check broadcasts itself.

    Returns:
        The transforms of the frame.

    Raises:
        CheckFailed: Nothing was heard, the two are swapped, or names differ.
    """
    own = [transform for transform in heard if transform.child not in given]
    swapped = [one for one in heard if (one.parent, one.child) == (child, parent)]
    expect(
        not swapped,
        f"parent and child are swapped: {parent} is the child of {child}",
        hint=f"The child comes before the parent: {SEND}.",
    )
    expect(
        own,
        f"no transform of {child} was received",
        hint=f"Broadcast it in a loop: {SEND}.",
    )
    pairs = sorted({(transform.parent, transform.child) for transform in own})
    expect(
        pairs == [(parent, child)],
        f"expected the one transform {parent} -> {child}, got "
        + ", ".join(f"{one} -> {other}" for one, other in pairs),
        hint=f'The parent is "{parent}", the child "{child}". Capital letters count.',
    )
    return own


def age_of(sim: Simulation, child: str, parent: str) -> float:
    """How old the newest transform from a parent to its child is [s]; 0 for a static one.

    Raises:
        TransformException: There is none.
    """
    stamp = sim.tf.get_latest_common_time(parent, child)
    return 0.0 if stamp.is_zero() else (sim.now - stamp).to_sec()
