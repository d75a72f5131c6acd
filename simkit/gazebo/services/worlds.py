"""Services of the world as a whole: time, gravity, what is in it."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from simkit.errors import SimkitError
from simkit.gazebo.poses import vector_of
from simkit.gazebo.server import Gazebo
from simkit.gazebo.services.service import GazeboService


class WorldServices:
    """Services of the world as a whole: time, gravity, what is in it.

    Args:
        gazebo: The world.
    """

    def __init__(self, gazebo: Gazebo) -> None:
        self._gazebo = gazebo

    def services(self) -> list[GazeboService]:
        """All of them."""
        empty = "std_srvs/Empty"
        return [
            GazeboService(
                name="pause_physics", type_name=empty, answer=self._doing(self._gazebo.pause)
            ),
            GazeboService(
                name="unpause_physics", type_name=empty, answer=self._doing(self._gazebo.unpause)
            ),
            GazeboService(
                name="reset_world", type_name=empty, answer=self._doing(self._gazebo.reset_world)
            ),
            GazeboService(
                name="reset_simulation",
                type_name=empty,
                answer=self._doing(self._gazebo.reset_simulation),
            ),
            GazeboService(
                name="get_world_properties",
                type_name="gazebo_msgs/GetWorldProperties",
                answer=self._get_world,
            ),
            GazeboService(
                name="get_physics_properties",
                type_name="gazebo_msgs/GetPhysicsProperties",
                answer=self._get_physics,
            ),
            GazeboService(
                name="set_physics_properties",
                type_name="gazebo_msgs/SetPhysicsProperties",
                answer=self._set_physics,
            ),
        ]

    @staticmethod
    def _doing(act: Callable[[], None]) -> Callable[[Any, Any], str]:
        def answer(_request: Any, _response: Any) -> str:
            act()
            return ""

        return answer

    def _get_world(self, _request: Any, response: Any) -> str:
        response.sim_time = self._gazebo.world.time_ns * 1e-9
        response.model_names = list(self._gazebo.world.models)
        response.rendering_enabled = True
        return "GetWorldProperties: got properties"

    def _get_physics(self, _request: Any, response: Any) -> str:
        response.time_step = self._gazebo.world.step_ns * 1e-9
        response.pause = self._gazebo.paused
        response.max_update_rate = 1e9 / self._gazebo.world.step_ns
        gravity = response.gravity
        gravity.x, gravity.y, gravity.z = self._gazebo.world.gravity
        return "GetPhysicsProperties: got properties"

    def _set_physics(self, request: Any, _response: Any) -> str:
        step_s = self._gazebo.world.step_ns * 1e-9
        if request.time_step and abs(request.time_step - step_s) > 1e-12:
            raise SimkitError(
                f"SetPhysicsProperties: steps are of {step_s:g} s here; write <max_step_size> in the world file"
            )
        self._gazebo.world.gravity = vector_of(request.gravity)
        return "physics engine updated"
