"""Services that tell where links are, and what they weigh."""

from __future__ import annotations

from typing import Any

from simkit.errors import SimkitError
from simkit.gazebo.poses import pose_message, transform_of_message, twist_message, vector_of
from simkit.gazebo.server import Gazebo
from simkit.gazebo.services.service import GazeboService, link_of
from simkit.geometry import Transform


class LinkServices:
    """Services that tell where links are, and what they weigh.

    Args:
        gazebo: The world.
    """

    def __init__(self, gazebo: Gazebo) -> None:
        self._gazebo = gazebo

    def services(self) -> list[GazeboService]:
        """All of them."""
        return [
            GazeboService(
                name="set_link_state", type_name="gazebo_msgs/SetLinkState", answer=self._set_state
            ),
            GazeboService(
                name="get_link_state", type_name="gazebo_msgs/GetLinkState", answer=self._get_state
            ),
            GazeboService(
                name="get_link_properties",
                type_name="gazebo_msgs/GetLinkProperties",
                answer=self._get_properties,
            ),
        ]

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
