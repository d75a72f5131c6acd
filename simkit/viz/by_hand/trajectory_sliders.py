"""The window of rqt_joint_trajectory_controller in a notebook: a slider per joint, and how long a motion takes."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from simkit.errors import SimkitError, UnknownNameError
from simkit.graph import Node
from simkit.msgs import Duration, message_class
from simkit.viz.by_hand.controlled_joints import ControlledJoint
from simkit.viz.by_hand.notebook_widgets import BOX, NotebookWidgets, ipywidgets_for
from simkit.viz.by_hand.slider_place import is_drawn_there
from simkit.viz.kernel_loop import KernelLoop, Later

STEPS = 1000
"""Places of a slider for mouse and arrow keys; a number that is typed beside it counts exactly."""
SLICE = 0.1
"""So much virtual time passes in one go [s], so that other views see the motion."""
REST = 0.05
"""So much longer than a motion time passes [s], until the controller has told of its end."""
_SHORTEST, _LONGEST = 0.01, 60.0
"Of a motion [s]."


class TrajectorySliders(NotebookWidgets):
    """Sends goals to a joint trajectory controller.

    When a slider is let go, the positions of all sliders are one goal, to be reached `duration` later;
    virtual time passes until then. While a cell runs, a goal waits for its end.

    Args:
        node: The node that publishes.
        controller: Resolved name of the controller, e.g. `/arm_controller`.
        joints: Its joints, in the order of its parameter.
        duration: Virtual time of a motion [s].
        run: Lets virtual time pass [s].
        later: Where a run waits for its turn; the kernel's event loop if None.

    Raises:
        SimkitError: The duration is not between 0.01 s and 60 s.
    """

    def __init__(
        self,
        node: Node,
        controller: str,
        joints: Sequence[ControlledJoint],
        *,
        duration: float,
        run: Callable[[float], None],
        later: Later | None = None,
    ) -> None:
        self._node, self._controller, self._run = node, controller, run
        self._joints = {joint.name: joint for joint in joints}
        self._duration = _checked(duration)
        self._command: Any = message_class("trajectory_msgs/JointTrajectory")
        self._point: Any = message_class("trajectory_msgs/JointTrajectoryPoint")
        self._publisher = node.advertise(f"{controller}/command", self._command)
        self._later = later or KernelLoop()
        actual = self.actual()
        self._goal = {
            name: joint.clipped(actual.get(name, 0.0)) for name, joint in self._joints.items()
        }
        self._sliders: dict[str, Any] = {}
        self._readouts: dict[str, Any] = {}
        self._box: Any = None
        self._is_waiting = False

    @property
    def goal(self) -> dict[str, float]:
        """Where the sliders stand, by joint [rad or m]."""
        return dict(self._goal)

    @property
    def widget(self) -> Any:
        """The ipywidgets box.

        Raises:
            SimkitError: ipywidgets is not installed.
        """
        if self._box is None:
            self._box = self._build(ipywidgets_for("the sliders"))
            self.refresh()
        return self._box

    def actual(self) -> dict[str, float]:
        """Where the joints are, as the controller has told it, or else /joint_states; empty if neither has."""
        for topic, read in (
            (f"{self._controller}/state", _of_state),
            ("/joint_states", _of_joints),
        ):
            known = self._node.graph.topics.get(topic)
            if known is not None and known.last is not None:
                found = read(known.message_class.from_bytes(known.last))
                if found:
                    return found
        return {}

    def move(self, positions: Mapping[str, float], *, duration: float | None = None) -> None:
        """Send a goal, and let virtual time pass until it should be reached.

        Args:
            positions: Of some joints [rad or m]; the others keep the goal that they have.
            duration: Virtual time of the motion [s]; that of the sliders if None.

        Raises:
            UnknownNameError: The controller has no such joint.
            SimkitError: A position is beyond a limit of its joint, or the duration is out of range.
        """
        for name, position in positions.items():
            if name not in self._joints:
                raise UnknownNameError(f"joint of {self._controller}", name, self._joints)
            joint = self._joints[name]
            if not joint.lower <= position <= joint.upper:
                raise SimkitError(
                    f"{name} goes from {joint.lower:.4g} to {joint.upper:.4g} {joint.unit}, not to {position:g}"
                )
        duration = self._duration if duration is None else _checked(duration)
        self._goal.update(positions)
        self._send(duration)
        self.refresh()

    def refresh(self) -> None:
        """Show the goals, and where the joints are now."""
        if self._box is None:
            return
        actual = self.actual()
        for name, slider in self._sliders.items():
            slider.value = self._goal[name]
            found = actual.get(name)
            text = "" if found is None else f"is at {found:.3f} {self._joints[name].unit}"
            self._readouts[name].value = text

    def __repr__(self) -> str:
        actual = self.actual()
        rows = [
            f"{name:>12}  goal {goal:.3f} {self._joints[name].unit}, "
            + (f"is at {actual[name]:.3f}" if name in actual else "not heard of yet")
            for name, goal in self._goal.items()
        ]
        first = next(iter(self._joints))
        how = f'  From Python: sliders.move({{"{first}": 0.5}})'
        return "\n".join([f"TrajectorySliders of {self._controller}", *rows, how])

    # -- the widgets

    def _build(self, widgets: Any) -> Any:
        rows = [self._row(widgets, joint) for joint in self._joints.values()]
        self.message = widgets.Label(layout={"display": "none"})
        duration = widgets.BoundedFloatText(
            value=self._duration,
            min=_SHORTEST,
            max=_LONGEST,
            step=0.1,
            description="duration [s]",
            style={"description_width": "8em"},
            layout={"width": "15em"},
        )
        duration.observe(lambda change: self._set_duration(change["new"]), names="value")
        zero = widgets.Button(description="All to zero")
        zero.on_click(lambda _: self._on_zero())
        title = widgets.Label(f"Controller: {self._controller}", style={"font_weight": "bold"})
        return widgets.VBox(
            [title, *rows, widgets.HBox([duration, zero]), self.message], layout=BOX
        )

    def _row(self, widgets: Any, joint: ControlledJoint) -> Any:
        slider = widgets.FloatSlider(
            value=self._goal[joint.name],
            description=joint.name,
            min=joint.lower,
            max=joint.upper,
            step=(joint.upper - joint.lower) / STEPS or 1.0,
            readout_format=".3f",
            continuous_update=False,
            style={"description_width": "8em"},
            layout={"width": "32em"},
        )
        slider.observe(lambda change: self._on_move(joint.name, change["new"]), names="value")
        self._sliders[joint.name] = slider
        self._readouts[joint.name] = widgets.Label(layout={"width": "10em"})
        return widgets.HBox([slider, self._readouts[joint.name]])

    def _set_duration(self, duration: float) -> None:
        self._duration = duration

    def _on_zero(self) -> None:
        self._goal = {name: joint.clipped(0.0) for name, joint in self._joints.items()}
        self._soon()

    def _on_move(self, name: str, value: float) -> None:
        slider = self._sliders[name]
        if is_drawn_there(value, self._goal[name], low=slider.min, step=slider.step):
            return
        self._goal[name] = value
        self._soon()

    # -- motions

    def _soon(self) -> None:
        if not self._is_waiting:
            self._is_waiting = True
            self._later.soon(self._advance)

    def _advance(self) -> None:
        self._is_waiting = False
        try:
            self._send(self._duration)
            self.say("" if self._publisher.num_connections else _silence(self._publisher.topic))
        except SimkitError as error:
            self.say(str(error))
        self.refresh()

    def _send(self, duration: float) -> None:
        goal = self._point(
            positions=list(self._goal.values()), time_from_start=Duration.from_sec(duration)
        )
        self._publisher.publish(self._command(joint_names=list(self._goal), points=[goal]))
        slices = max(1, math.ceil(duration / SLICE - 1e-9))
        for _ in range(slices):
            self._run(duration / slices)
        self._run(REST)


def _silence(topic: str) -> str:
    return f"No node listens to {topic}: is the controller loaded and started?"


def _of_state(state: Any) -> dict[str, float]:
    return dict(zip(state.joint_names, state.actual.positions, strict=False))


def _of_joints(state: Any) -> dict[str, float]:
    return dict(zip(state.name, state.position, strict=False))


def _checked(duration: float) -> float:
    if not _SHORTEST <= duration <= _LONGEST:
        raise SimkitError(f"a motion takes from {_SHORTEST:g} to {_LONGEST:g} s, not {duration} s")
    return float(duration)
