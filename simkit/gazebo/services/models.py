"""Services that say and set where models, their joints and their links are, and what links weigh."""

from __future__ import annotations

import math
from typing import Any

from simkit.errors import SimkitError
from simkit.gazebo.poses import pose_message, transform_of_message, twist_message, vector_of
from simkit.gazebo.server import Gazebo
from simkit.gazebo.services.service import ServiceGroup, answers, link_of, model_of
from simkit.geometry import Transform
from simkit.physics import JointKind, Model, ModelJoint

_REVOLUTE, _CONTINUOUS, _PRISMATIC = 0, 1, 2


class ModelServices(ServiceGroup):
    """Services that say and set where models and their joints are."""

    @answers("get_model_state", "gazebo_msgs/GetModelState")
    def _get_state(self, request: Any, response: Any) -> str:
        model = model_of(self._gazebo, request.model_name, "GetModelState")
        frame = self._gazebo.frame(request.relative_entity_name)
        linear, angular = model.twist
        response.header.stamp = self._gazebo.node.now()
        response.header.frame_id = request.relative_entity_name
        response.pose = pose_message(frame.inverse() @ model.pose)
        response.twist = twist_message((frame.rotate_back(linear), frame.rotate_back(angular)))
        return "GetModelState: got properties"

    @answers("set_model_state", "gazebo_msgs/SetModelState")
    def _set_state(self, request: Any, _response: Any) -> str:
        set_model_state(self._gazebo, request.model_state)
        return "SetModelState: set model state done"

    @answers("set_model_configuration", "gazebo_msgs/SetModelConfiguration")
    def _set_configuration(self, request: Any, _response: Any) -> str:
        model = model_of(self._gazebo, request.model_name, "SetModelConfiguration")
        names, positions = request.joint_names, request.joint_positions
        if len(names) != len(positions):
            raise SimkitError(
                "SetModelConfiguration: joint name and position list have different lengths: "
                f"{len(names)} and {len(positions)}"
            )
        model.set_joint_positions(dict(zip(names, positions, strict=True)))
        return "SetModelConfiguration: success"

    @answers("get_model_properties", "gazebo_msgs/GetModelProperties")
    def _get_properties(self, request: Any, response: Any) -> str:
        model = model_of(self._gazebo, request.model_name, "GetModelProperties")
        response.canonical_body_name = next(iter(model.plan.bodies), "")
        response.body_names = list(model.plan.bodies)
        response.joint_names = list(model.joints)
        response.geom_names = [
            shape.name for body in model.plan.bodies.values() for shape in body.shapes
        ]
        response.is_static = model.plan.is_static
        return "GetModelProperties: got properties"

    @answers("get_joint_properties", "gazebo_msgs/GetJointProperties")
    def _get_joint(self, request: Any, response: Any) -> str:
        joint = joint_of(self._gazebo, request.joint_name, "GetJointProperties")
        response.type = _joint_type(joint)
        response.damping = [joint.plan.damping]
        response.position = [joint.position]
        response.rate = [joint.velocity]
        return "GetJointProperties: got properties"


class LinkServices(ServiceGroup):
    """Services that say where links are, and what they weigh."""

    @answers("get_link_state", "gazebo_msgs/GetLinkState")
    def _get_state(self, request: Any, response: Any) -> str:
        model, link = link_of(self._gazebo, request.link_name, "GetLinkState")
        frame = self._gazebo.frame(request.reference_frame)
        linear, angular = model.link_twist(link)
        state = response.link_state
        state.link_name = request.link_name
        state.pose = pose_message(frame.inverse() @ model.link_pose(link))
        state.twist = twist_message((frame.rotate_back(linear), frame.rotate_back(angular)))
        state.reference_frame = request.reference_frame
        return "GetLinkState: got state"

    @answers("get_link_properties", "gazebo_msgs/GetLinkProperties")
    def _get_properties(self, request: Any, response: Any) -> str:
        model, link = link_of(self._gazebo, request.link_name, "GetLinkProperties")
        if link not in model.plan.bodies:
            mount = model.plan.mounts[link].body
            raise SimkitError(f"GetLinkProperties: {link} is a part of {mount}, ask for that one")
        plan = model.plan.bodies[link]
        body = plan.body
        response.com = pose_message(Transform(body.centre))
        response.gravity_mode = plan.gravity
        response.mass = body.mass
        tensor = body.tensor
        response.ixx, response.ixy, response.ixz = tensor[0]
        response.iyy, response.iyz = tensor[1][1:]
        response.izz = tensor[2][2]
        return "GetLinkProperties: got properties"

    @answers("set_link_state", "gazebo_msgs/SetLinkState")
    def _set_state(self, request: Any, _response: Any) -> str:
        state = request.link_state
        model, link = link_of(self._gazebo, state.link_name, "SetLinkState")
        root = next(iter(model.plan.bodies))
        if model.plan.mounts[link].body != root:
            raise SimkitError(
                f"SetLinkState: {link} hangs on joints: set these (/gazebo/set_model_configuration), or "
                f"the link {root}, which carries all of {model.name}"
            )
        frame = self._gazebo.frame(state.reference_frame)
        there = frame @ transform_of_message(state.pose)
        model.set_pose(there @ (model.link_pose(link).inverse() @ model.pose))
        model.set_twist(
            frame.rotate(vector_of(state.twist.linear)),
            frame.rotate(vector_of(state.twist.angular)),
        )
        return "SetLinkState: success"


def set_model_state(gazebo: Gazebo, state: Any) -> None:
    """Put a model where a `gazebo_msgs/ModelState` says, with the velocity that it says.

    Raises:
        SimkitError: There is no such model or frame, or a number is NaN.
    """
    model = model_of(gazebo, state.model_name, "SetModelState")
    frame = gazebo.frame(state.reference_frame)
    model.set_pose(frame @ transform_of_message(state.pose))
    model.set_twist(
        frame.rotate(vector_of(state.twist.linear)), frame.rotate(vector_of(state.twist.angular))
    )


def joint_of(gazebo: Gazebo, name: str, service: str) -> ModelJoint:
    """A joint that moves, by its name; the first model that has it counts, as in Gazebo.

    Raises:
        SimkitError: No model has such a joint.
    """
    model_name, separator, joint = name.partition("::")
    models: list[Model] = list(gazebo.world.models.values())
    if separator:
        models, name = [one for one in models if one.name == model_name], joint
    for model in models:
        if name in model.joints:
            return model.joints[name]
    known = [each for one in gazebo.world.models.values() for each in one.joints]
    raise SimkitError(f"{service}: joint [{name}] not found; joints here: {', '.join(known)}")


def _joint_type(joint: ModelJoint) -> int:
    if joint.plan.kind is JointKind.PRISMATIC:
        return _PRISMATIC
    is_endless = math.isinf(joint.plan.lower) and math.isinf(joint.plan.upper)
    return _CONTINUOUS if is_endless else _REVOLUTE
