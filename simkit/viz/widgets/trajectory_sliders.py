"""The window of rqt_joint_trajectory_controller in a notebook: a slider per joint, and how long a motion takes."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from simkit.errors import SimkitError, UnknownNameError
from simkit.graph import Graph, Node
from simkit.msgs import Duration, message_class
from simkit.urdf import Joint, JointType, load_robot
from simkit.viz.widgets.kernel_loop import Later
from simkit.viz.widgets.panel import Panel

SLICE = 0.1
"""So much virtual time passes in one go [s], so that other views see the motion."""
REST = 0.05
"""So much longer than a motion time passes [s], until the controller has published its end."""
_KIND = "/JointTrajectoryController"
_SHORTEST, _LONGEST = 0.01, 60.0
"Of a motion [s]."


@dataclass(frozen=True, slots=True, kw_only=True)
class ControlledJoint:
    """A joint with a slider."""

    name: str
    """Its name."""
    lower: float
    """Least position [rad or m]; -pi if it turns without end."""
    upper: float
    """Greatest position [rad or m]; pi if it turns without end."""
    unit: str
    """`rad` or `m`."""

    def clipped(self, position: float) -> float:
        """The nearest position that it can go to."""
        return min(max(position, self.lower), self.upper)


class TrajectorySliders(Panel):
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
        picture: Makes a small picture of how the robot stands, as a PNG file; without it, there is none.
        view: A live view of the robot, which is shown beside the sliders in place of the picture.

    Raises:
        SimkitError: The duration is not between 0.01 s and 60 s.
    """

    SCRIPT = "sliders"

    def __init__(
        self,
        node: Node,
        controller: str,
        joints: Sequence[ControlledJoint],
        *,
        duration: float,
        run: Callable[[float], None],
        later: Later | None = None,
        picture: Callable[[], bytes] | None = None,
        view: Any = None,
    ) -> None:
        super().__init__(later=later, view=view, png=picture)
        self._node, self._controller, self._run = node, controller, run
        self._joints = {joint.name: joint for joint in joints}
        self._duration = _checked(duration)
        self._command: Any = message_class("trajectory_msgs/JointTrajectory")
        self._point: Any = message_class("trajectory_msgs/JointTrajectoryPoint")
        self._publisher = node.advertise(f"{controller}/command", self._command)
        actual = self.actual()
        self._goal = {
            name: joint.clipped(actual.get(name, 0.0)) for name, joint in self._joints.items()
        }

    @property
    def goal(self) -> dict[str, float]:
        """Where the sliders stand, by joint [rad or m]."""
        return dict(self._goal)

    def actual(self) -> dict[str, float]:
        """Where the joints are, as the controller publishes it, or else /joint_states; empty without both."""
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

    def state(self) -> dict[str, Any]:
        """The joints with their ranges and goals, and where they are now."""
        actual = self.actual()
        return {
            "title": f"Controller: {self._controller}",
            "joints": [self._row(joint, actual.get(joint.name)) for joint in self._joints.values()],
            "buttons": ["All to zero"],
            "duration": self._duration,
            "follows": False,
            "disabled": False,
            "message": self._message,
        }

    def stand(self) -> str:
        """Where each joint is."""
        return ", ".join(f"{name} at {value:.3f}" for name, value in self.actual().items())

    def hear(self, message: Mapping[str, Any]) -> None:
        """A slider was let go, the button pressed, or another duration typed."""
        match message:
            case {"move": str(name), "to": float() | int() as position} if name in self._joints:
                self._goal[name] = self._joints[name].clipped(position)
                self._soon(self._advance)
            case {"press": "All to zero"}:
                self._goal = {name: joint.clipped(0.0) for name, joint in self._joints.items()}
                self._soon(self._advance)
            case {"duration": float() | int() as duration}:
                self._attempt(lambda: self._set_duration(duration))

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

    def _row(self, joint: ControlledJoint, actual: float | None) -> dict[str, Any]:
        return {
            "name": joint.name,
            "lower": joint.lower,
            "upper": joint.upper,
            "unit": joint.unit,
            "value": self._goal[joint.name],
            "words": joint.unit if actual is None else f"{joint.unit}, is at {actual:.3f}",
        }

    def _set_duration(self, duration: float) -> None:
        self._duration = _checked(duration)
        self.say("")

    # -- motions

    def _advance(self) -> None:
        if self._attempt(lambda: self._send(self._duration)):
            self.say("" if self._publisher.num_connections else _silence(self._publisher.topic))
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


def controlled_joints(
    graph: Graph, controller: str, *, description: str = "/robot_description"
) -> tuple[ControlledJoint, ...]:
    """The joints of a controller, in its order.

    Args:
        graph: Has the parameters.
        controller: Resolved name of the controller, e.g. `/arm_controller`.
        description: Parameter with the URDF of the robot, which has the limits.

    Raises:
        SimkitError: The controller has no parameter `joints`, the robot has no such joint, or there is no robot.
        UrdfError: The robot cannot be read.
    """
    names = graph.params.get(f"{controller}/joints", None)
    if not isinstance(names, list) or not names or not all(isinstance(n, str) for n in names):
        raise SimkitError(
            f"Could not find 'joints' parameter (namespace: {controller}), a list of names. "
            f"{_known(_controllers(graph))} Load the configuration first, e.g. rosparam load in a launch file."
        )
    text = graph.params.get(description, None)
    if not isinstance(text, str):
        raise SimkitError(
            f"parameter {description} holds no URDF, and the limits of joints are in it"
        )
    joints = load_robot(text, file=description).joints
    for name in names:
        if name not in joints:
            raise UnknownNameError(f"joint of {controller}/joints in {description}", name, joints)
    return tuple(_controlled(joints[name]) for name in names)


def _controlled(joint: Joint) -> ControlledJoint:
    lower, upper = -math.pi, math.pi
    if joint.type is not JointType.CONTINUOUS and joint.limit is not None:
        lower, upper = sorted((joint.limit.lower, joint.limit.upper))
    unit = "m" if joint.type is JointType.PRISMATIC else "rad"
    return ControlledJoint(name=joint.name, lower=lower, upper=upper, unit=unit)


def _controllers(graph: Graph) -> list[str]:
    """Names below the root that have a type of trajectory controller."""
    tree: Any = graph.params.get("/", {})
    found = []
    for name, value in sorted(tree.items()) if isinstance(tree, dict) else ():
        if isinstance(value, dict) and str(value.get("type", "")).endswith(_KIND):
            found.append(f"/{name}")
    return found


def _known(controllers: Iterable[str]) -> str:
    names = ", ".join(controllers)
    return (
        f"Trajectory controllers with parameters: {names}." if names else "No controller has any."
    )
