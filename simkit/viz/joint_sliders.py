"""The window of joint_state_publisher_gui in a notebook: a slider per joint, Randomize, Center."""

from __future__ import annotations

import base64
import html
import math
from collections.abc import Callable
from typing import Any

from simkit.errors import SimkitError
from simkit.nodes.joint_state_publisher import JointStatePublisherGui, SliderJoint
from simkit.viz.by_hand.notebook_widgets import BOX, NotebookWidgets, ipywidgets_for
from simkit.viz.by_hand.slider_place import is_drawn_there
from simkit.viz.kernel_loop import KernelLoop, Later

STEPS = 1000
"""Places of a slider for mouse and arrow keys; a number that is typed beside it counts exactly."""
_SETTLED = 0.1
"""So long after the last move the other views are drawn once more [s of wall-clock time]."""


class JointSliders(NotebookWidgets):
    """Moves the joints of a joint_state_publisher_gui by hand.

    Each move lets the simulation run until the node has told it, so that tf and the other views
    follow. While a cell runs, a move counts at once, and time passes when the cell is done.

    Where widgets cannot be shown (a plain terminal, a saved notebook without a kernel) it is a
    table of the positions, with the line of Python that moves a joint, and a picture of the robot.

    Args:
        gui: The program whose joints are moved.
        run: Lets virtual time pass [s].
        later: Where a run waits for its turn; the kernel's event loop if None.
        picture: Makes a small picture of how the robot stands, as a PNG file; without it, there is none.
    """

    def __init__(
        self,
        gui: JointStatePublisherGui,
        *,
        run: Callable[[float], None],
        later: Later | None = None,
        picture: Callable[[], bytes] | None = None,
    ) -> None:
        self._gui = gui
        self._run = run
        self._later = later or KernelLoop()
        self._picture = picture
        self._shown: dict[str, float] = {}
        self._sliders: dict[str, Any] = {}
        self._readouts: dict[str, Any] = {}
        self._buttons: tuple[Any, ...] = ()
        self._box: Any = None
        self._is_waiting = False

    @property
    def gui(self) -> JointStatePublisherGui:
        """The program whose joints are moved."""
        return self._gui

    @property
    def title(self) -> str:
        """What stands above the sliders, as in the original window."""
        return self._gui.title

    @property
    def widget(self) -> Any:
        """The ipywidgets box.

        Raises:
            SimkitError: ipywidgets is not installed.
        """
        if self._box is None:
            self._box = self._build(ipywidgets_for("the sliders"))
        return self._box

    def refresh(self) -> None:
        """Show where the joints stand now."""
        if self._box is None:
            return
        for joint in self._gui.joints:
            if joint.position != self._shown.get(joint.name):
                self._show(joint)
        if not self._gui.alive:
            self.say(f"{self._gui.name} has ended")
            for control in (*self._sliders.values(), *self._buttons):
                control.disabled = True

    def set_position(self, name: str, value: float) -> None:
        """Move a joint to this position [rad or m], and let time pass until the node has told it.

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
            f"{self._image()}<b>{html.escape(self.title)}</b><table>{rows}</table>"
            f"<small>Sliders need a running notebook. {html.escape(self._how_to())}</small>"
        )

    def _image(self) -> str:
        if self._picture is None:
            return ""
        data = base64.b64encode(self._picture()).decode("ascii")
        stand = ", ".join(f"{joint.name} {_readout(joint)}" for joint in self._gui.joints)
        words = html.escape(f"The robot with {stand}" if stand else "The robot")
        return f'<img alt="{words}" src="data:image/png;base64,{data}" style="display:block">'

    def _how_to(self) -> str:
        joints = self._gui.joints
        if not joints:
            return "This robot has no joint to move."
        low, high = sorted((joints[0].lower, joints[0].upper))
        example = round(min(max(0.5, low), high), 3)
        if not low <= example <= high:
            example = joints[0].position
        return f'From Python: sim.joint_sliders().set_position("{joints[0].name}", {example:g})'

    # -- the widgets

    def _build(self, widgets: Any) -> Any:
        rows = [self._row(widgets, joint) for joint in self._gui.joints]
        self.message = widgets.Label(layout={"display": "none"})
        self._buttons = (
            self._button(widgets, "Randomize", self._gui.randomize),
            self._button(widgets, "Center", self._gui.center),
        )
        title = widgets.Label(self.title, style={"font_weight": "bold"})
        empty = [] if rows else [widgets.Label("This robot has no joint to move.")]
        buttons = widgets.HBox(self._buttons)
        return widgets.VBox(
            [title, *rows, *empty, buttons, self.message],
            layout=BOX,
        )

    def _row(self, widgets: Any, joint: SliderJoint) -> Any:
        low, high = sorted((joint.lower, joint.upper))
        slider = widgets.FloatSlider(
            description=joint.name,
            min=low,
            max=high,
            step=(high - low) / STEPS,
            readout_format=".3f",
            style={"description_width": "8em"},
            layout={"width": "32em"},
        )
        self._sliders[joint.name] = slider
        self._readouts[joint.name] = widgets.Label(layout={"width": "8em"})
        self._show(joint)
        slider.observe(lambda change: self._on_move(joint.name, change["new"]), names="value")
        return widgets.HBox([slider, self._readouts[joint.name]])

    def _button(self, widgets: Any, text: str, act: Callable[[], None]) -> Any:
        button = widgets.Button(description=text)
        button.on_click(lambda _: self._do(act))
        return button

    def _show(self, joint: SliderJoint) -> None:
        slider = self._sliders[joint.name]
        if not math.isfinite(joint.position):
            return  # a source may say anything
        value = min(max(joint.position, slider.min), slider.max)
        self._shown[joint.name] = value
        slider.value = value
        self._readouts[joint.name].value = _unit_and_degrees(joint)

    # -- moves

    def _on_move(self, name: str, value: float) -> None:
        if self._is_of_this_view(name, value):
            return
        self._shown[name] = value
        self._do(lambda: self._gui.set_position(name, value))

    def _is_of_this_view(self, name: str, value: float) -> bool:
        slider, shown = self._sliders[name], self._shown.get(name)
        return shown is not None and is_drawn_there(value, shown, low=slider.min, step=slider.step)

    def _do(self, act: Callable[[], None]) -> None:
        self.say("")
        try:
            act()
        except SimkitError as error:
            self.say(str(error))
        for joint in self._gui.joints:
            self._show(joint)
        # Moves come faster than they can be shown: all that came meanwhile are one run.
        if not self._is_waiting:
            self._is_waiting = True
            self._later.soon(self._advance)

    def _advance(self) -> None:
        self._is_waiting = False
        self._let_pass(self._gui.period.to_sec())
        self._later.after(_SETTLED, self._settle)
        self.refresh()

    def _settle(self) -> None:
        """Draw the other views once more: they may have passed over the last of many moves."""
        if not self._is_waiting:
            self._let_pass(0.0)
            if self._still is not None:
                self._still.refresh()

    def _let_pass(self, seconds: float) -> None:
        try:
            self._run(seconds)
        except SimkitError as error:
            self.say(str(error))


def _readout(joint: SliderJoint) -> str:
    return f"{joint.position:.3f} {_unit_and_degrees(joint)}"


def _unit_and_degrees(joint: SliderJoint) -> str:
    if joint.unit != "rad":
        return joint.unit
    degrees = round(math.degrees(joint.position), 1) + 0.0  # no -0.0
    return f"rad = {degrees:.1f}°"
