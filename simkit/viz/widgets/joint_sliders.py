"""The window of joint_state_publisher_gui in a notebook: a slider per joint, Randomize, Center."""

from __future__ import annotations

import html
import math
from collections.abc import Callable, Mapping
from typing import Any

from simkit.nodes.joint_state_publisher import JointStatePublisherGui, SliderJoint
from simkit.viz.widgets.kernel_loop import Later
from simkit.viz.widgets.panel import Panel, picture_html

_SETTLED = 0.1
"""So long after the last move the other views are drawn once more [s of wall-clock time]."""


class JointSliders(Panel):
    """Moves the joints of a joint_state_publisher_gui by hand.

    Each move lets the simulation run until the node has published it, so that tf and the other views
    follow. While a cell runs, a move counts at once, and time passes when the cell is done.

    Where widgets cannot be shown (a plain terminal, a saved notebook without a kernel) it is a
    table of the positions, with the line of Python that moves a joint, and a picture of the robot.

    Args:
        gui: The program whose joints are moved.
        run: Lets virtual time pass [s].
        later: Where a run waits for its turn; the kernel's event loop if None.
        picture: Makes a small picture of how the robot stands, as a PNG file; without it, there is none.
        view: A live view of the robot, which is shown beside the sliders in place of the picture.
    """

    SCRIPT = "sliders"

    def __init__(
        self,
        gui: JointStatePublisherGui,
        *,
        run: Callable[[float], None],
        later: Later | None = None,
        picture: Callable[[], bytes] | None = None,
        view: Any = None,
    ) -> None:
        super().__init__(later=later, view=view, png=picture)
        self._gui = gui
        self._run = run
        self._shown: dict[str, float] = {}

    @property
    def gui(self) -> JointStatePublisherGui:
        """The program whose joints are moved."""
        return self._gui

    @property
    def title(self) -> str:
        """What stands above the sliders, as in the original window."""
        return self._gui.title

    def state(self) -> dict[str, Any]:
        """The joints with their ranges, where they stand, and the buttons."""
        has_ended = not self._gui.alive
        return {
            "title": self.title,
            "joints": [self._row(joint) for joint in self._gui.joints],
            "buttons": ["Randomize", "Center"],
            "duration": None,
            "follows": True,
            "disabled": has_ended,
            "message": f"{self._gui.name} has ended" if has_ended else self._message,
        }

    def stand(self) -> str:
        """The position of each joint."""
        return ", ".join(f"{joint.name} {_readout(joint)}" for joint in self._gui.joints)

    def hear(self, message: Mapping[str, Any]) -> None:
        """A slider was moved, or a button pressed."""
        match message:
            case {"move": str(name), "to": float() | int() as position}:
                self._do(lambda: self._gui.set_position(name, position))
            case {"press": "Randomize"}:
                self._do(self._gui.randomize)
            case {"press": "Center"}:
                self._do(self._gui.center)

    def set_position(self, name: str, value: float) -> None:
        """Move a joint to this position [rad or m], and let time pass until the node has published it.

        Raises:
            UnknownNameError: No joint of that name has a slider.
            SimkitError: The position is beyond an end of the slider.
        """
        self._gui.set_position(name, value)
        self._run(self._gui.period.to_sec())

    # -- what a notebook shows

    def __repr__(self) -> str:
        lines = [f"{joint.name:>12}  {_readout(joint)}" for joint in self._gui.joints]
        return "\n".join([self.title, *(lines or ["  no joint moves"]), f"  {self._how_to()}"])

    def _repr_html_(self) -> str:
        rows = "".join(
            f"<tr><th>{html.escape(joint.name)}</th><td>{html.escape(_readout(joint))}</td></tr>"
            for joint in self._gui.joints
        )
        return (
            f"{picture_html(self.picture())}<b>{html.escape(self.title)}</b><table>{rows}</table>"
            f"<small>Sliders need a running notebook. {html.escape(self._how_to())}</small>"
        )

    def _how_to(self) -> str:
        joints = self._gui.joints
        if not joints:
            return "This robot has no joint to move."
        low, high = sorted((joints[0].lower, joints[0].upper))
        example = round(min(max(0.5, low), high), 3)
        if not low <= example <= high:
            example = joints[0].position
        return f'From Python: sim.joint_sliders().set_position("{joints[0].name}", {example:g})'

    def _row(self, joint: SliderJoint) -> dict[str, Any]:
        low, high = sorted((joint.lower, joint.upper))
        if math.isfinite(joint.position):  # a source may say anything
            self._shown[joint.name] = min(max(joint.position, low), high)
        return {
            "name": joint.name,
            "lower": low,
            "upper": high,
            "unit": joint.unit,
            "value": self._shown.get(joint.name, low),
            "words": _unit_and_degrees(joint),
        }

    # -- moves

    def _do(self, act: Callable[[], None]) -> None:
        self._message = ""
        self._attempt(act)
        self.refresh()
        # Moves come faster than they can be shown: all that came meanwhile are one run.
        self._soon(self._advance)

    def _advance(self) -> None:
        self._attempt(lambda: self._run(self._gui.period.to_sec()))
        self._later.after(_SETTLED, self._settle)
        self.refresh()

    def _settle(self) -> None:
        """Draw the other views once more: they may have passed over the last of many moves."""
        if not self._is_waiting:
            self._attempt(lambda: self._run(0.0))
            if self._still is not None:
                self._still.refresh()


def _readout(joint: SliderJoint) -> str:
    return f"{joint.position:.3f} {_unit_and_degrees(joint)}"


def _unit_and_degrees(joint: SliderJoint) -> str:
    if joint.unit != "rad":
        return joint.unit
    degrees = round(math.degrees(joint.position), 1) + 0.0  # no -0.0
    return f"rad = {degrees:.1f}°"
