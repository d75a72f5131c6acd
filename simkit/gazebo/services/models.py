"""Services that tell and set where models and their joints are."""

from __future__ import annotations

import math
from typing import Any

from simkit.errors import SimkitError
from simkit.gazebo.poses import pose_message, transform_of_message, twist_message, vector_of
from simkit.gazebo.server import Gazebo
from simkit.gazebo.services.service import GazeboService, model_of
from simkit.physics import JointKind, Model, ModelJoint

_REVOLUTE, _CONTINUOUS, _PRISMATIC = 0, 1, 2


class ModelServices:
    """Services that tell and set where models and their joints are.

    Args:
        gazebo: The world.
    """

    def __init__(self, gazebo: Gazebo) -> None:
        self._gazebo = gazebo

    def services(self) -> list[GazeboService]:
        """All of them."""
        return [
            GazeboService(
                name="get_model_state",
                type_name="gazebo_msgs/GetModelState",
                answer=self._get_state,
            ),
            GazeboService(
                name="set_model_state",
                type_name="gazebo_msgs/SetModelState",
                answer=self._set_state,
            ),
            GazeboService(
                name="set_model_configuration",
                type_name="gazebo_msgs/SetModelConfiguration",
                answer=self._set_configuration,
            ),
            GazeboService(
                name="get_model_properties",
                type_name="gazebo_msgs/GetModelProperties",
                answer=self._get_properties,
            ),
            GazeboService(
                name="get_joint_properties",
                type_name="gazebo_msgs/GetJointProperties",
                answer=self._get_joint,
            ),
        ]

    def _get_state(self, request: Any, response: Any) -> str:
        model = model_of(self._gazebo, request.model_name, "GetModelState")
        frame = self._gazebo.frame(request.relative_entity_name)
        linear, angular = model.twist
        response.header.stamp = self._gazebo.node.now()
        response.header.frame_id = request.relative_entity_name
        response.pose = pose_message(frame.inverse() @ model.pose)
        response.twist = twist_message((frame.rotate_back(linear), frame.rotate_back(angular)))
        return "GetModelState: got properties"

    def _set_state(self, request: Any, _response: Any) -> str:
        set_model_state(self._gazebo, request.model_state)
        return "SetModelState: set model state done"

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

    def _get_joint(self, request: Any, response: Any) -> str:
        joint = joint_of(self._gazebo, request.joint_name, "GetJointProperties")
        response.type = _joint_type(joint)
        response.damping = [joint.plan.damping]
        response.position = [joint.position]
        response.rate = [joint.velocity]
        return "GetJointProperties: got properties"


def set_model_state(gazebo: Gazebo, state: Any) -> None:
    """Put a model where a `gazebo_msgs/ModelState` says, with the velocity that it says.

    Raises:
        SimkitError: There is no such model or frame, or a number is none.
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
