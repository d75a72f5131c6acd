"""Services that push links and drive joints, for a time.

Source: gazebo_ros_api_plugin: a negative duration is for ever, a force acts from its start time on.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from simkit.gazebo.poses import vector_of
from simkit.gazebo.server import Gazebo
from simkit.gazebo.services.models import joint_of
from simkit.gazebo.services.service import ServiceGroup, answers, link_of


@dataclass(frozen=True, slots=True, kw_only=True)
class _Push:
    key: str
    """What it acts on, e.g. `car::base_link`."""
    start_ns: int
    end_ns: float
    act: Callable[[], None]
    end: Callable[[], None]


class Pushes:
    """What pushes in the steps that come; it costs nothing while nothing pushes."""

    def __init__(self, gazebo: Gazebo) -> None:
        self._gazebo = gazebo
        self._pushes: list[_Push] = []

    def add(self, push: _Push) -> None:
        """Let it act from its start on."""
        if not self._pushes:
            self._gazebo.world.before_step.append(self._act)
        self._pushes.append(push)

    def clear(self, kind: str, key: str) -> None:
        """Take back what acts on something."""
        for push in [one for one in self._pushes if one.key == f"{kind} {key}"]:
            self._drop(push)

    def _act(self) -> None:
        now = self._gazebo.node.now().to_nsec()
        for push in tuple(self._pushes):
            if now >= push.end_ns:
                self._drop(push)
            elif now >= push.start_ns:
                push.act()

    def _drop(self, push: _Push) -> None:
        self._pushes.remove(push)
        push.end()
        if not self._pushes:
            self._gazebo.world.before_step.remove(self._act)


class PushServices(ServiceGroup):
    """Services that push links and drive joints, for a time.

    Args:
        gazebo: The world.
    """

    def __init__(self, gazebo: Gazebo) -> None:
        super().__init__(gazebo)
        self._pushes = Pushes(gazebo)
        # What acts on a model that is taken out must not act on.
        gazebo.on_delete.append(lambda spawned: self._pushes.clear("model", spawned.name))

    @answers("apply_body_wrench", "gazebo_msgs/ApplyBodyWrench")
    def _push_body(self, request: Any, _response: Any) -> str:
        model, link = link_of(self._gazebo, request.body_name, "ApplyBodyWrench")
        frame = self._gazebo.frame(request.reference_frame)
        force = frame.rotate(vector_of(request.wrench.force))
        torque = frame.rotate(vector_of(request.wrench.torque))
        here = frame.apply(vector_of(request.reference_point))
        point = model.link_pose(link).inverse().apply(here)
        if not request.reference_frame:
            point = (0.0, 0.0, 0.0)  # said in no frame: at the link itself
        start, end = _span(self._gazebo, request)

        def act() -> None:
            if model.name in self._gazebo.world.models:
                model.push(link, force=force, torque=torque, point=point)

        push = _Push(
            key=f"body {request.body_name}", start_ns=start, end_ns=end, act=act, end=_nothing
        )
        self._pushes.add(push)
        return "ApplyBodyWrench: success"

    @answers("apply_joint_effort", "gazebo_msgs/ApplyJointEffort")
    def _drive_joint(self, request: Any, _response: Any) -> str:
        joint = joint_of(self._gazebo, request.joint_name, "ApplyJointEffort")
        start, end = _span(self._gazebo, request)
        effort = request.effort
        push = _Push(
            key=f"joint {request.joint_name}",
            start_ns=start,
            end_ns=end,
            act=lambda: joint.command_effort(effort),
            end=joint.release,
        )
        self._pushes.add(push)
        return "ApplyJointEffort: effort set"

    @answers("clear_body_wrenches", "gazebo_msgs/BodyRequest")
    def _clear_body(self, request: Any, _response: Any) -> str:
        self._pushes.clear("body", request.body_name)
        return ""

    @answers("clear_joint_efforts", "gazebo_msgs/JointRequest")
    def _clear_joint(self, request: Any, _response: Any) -> str:
        self._pushes.clear("joint", request.joint_name)
        return ""


def _span(gazebo: Gazebo, request: Any) -> tuple[int, float]:
    """From when to when a request acts [ns]."""
    start = max(request.start_time.to_nsec(), gazebo.node.now().to_nsec())
    duration = request.duration.to_nsec()
    return start, float("inf") if duration < 0 else start + duration


def _nothing() -> None:
    """A push ends by not acting any more."""
