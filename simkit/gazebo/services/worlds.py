"""Services of the world as a whole: models come and go, time, gravity, what is in it."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from simkit.errors import SimkitError
from simkit.gazebo.models import Spawned
from simkit.gazebo.poses import transform_of_message, vector_of
from simkit.gazebo.services.service import ServiceGroup, answers, model_of

SPAWN, EMPTY = "gazebo_msgs/SpawnModel", "std_srvs/Empty"


class SpawnServices(ServiceGroup):
    """Services that bring models in and take them out."""

    @answers("spawn_urdf_model", SPAWN)
    def _spawn_urdf(self, request: Any, _response: Any) -> str:
        return _spawned(self._gazebo.spawn_urdf, request)

    @answers("spawn_sdf_model", SPAWN)
    def _spawn_sdf(self, request: Any, _response: Any) -> str:
        return _spawned(self._gazebo.spawn_sdf, request)

    @answers("delete_model", "gazebo_msgs/DeleteModel")
    def _delete(self, request: Any, _response: Any) -> str:
        model_of(self._gazebo, request.model_name, "DeleteModel")
        self._gazebo.delete(request.model_name)
        return "DeleteModel: successfully deleted model"


def _spawned(spawn: Callable[..., Spawned], request: Any) -> str:
    spawn(
        request.model_xml,
        name=request.model_name,
        pose=transform_of_message(request.initial_pose),
        namespace=request.robot_namespace or None,
        reference_frame=request.reference_frame,
    )
    return "SpawnModel: Successfully spawned entity"


class WorldServices(ServiceGroup):
    """Services of the world as a whole: time, gravity, what is in it."""

    @answers("pause_physics", EMPTY)
    def _pause(self, _request: Any, _response: Any) -> str:
        self._gazebo.pause()
        return ""

    @answers("unpause_physics", EMPTY)
    def _unpause(self, _request: Any, _response: Any) -> str:
        self._gazebo.unpause()
        return ""

    @answers("reset_world", EMPTY)
    def _reset_world(self, _request: Any, _response: Any) -> str:
        self._gazebo.reset_world()
        return ""

    @answers("reset_simulation", EMPTY)
    def _reset_simulation(self, _request: Any, _response: Any) -> str:
        self._gazebo.reset_simulation()
        return ""

    @answers("get_world_properties", "gazebo_msgs/GetWorldProperties")
    def _get_world(self, _request: Any, response: Any) -> str:
        response.sim_time = self._gazebo.world.time_ns * 1e-9
        response.model_names = list(self._gazebo.world.models)
        response.rendering_enabled = True
        return "GetWorldProperties: got properties"

    @answers("get_physics_properties", "gazebo_msgs/GetPhysicsProperties")
    def _get_physics(self, _request: Any, response: Any) -> str:
        response.time_step = self._gazebo.world.step_ns * 1e-9
        response.pause = self._gazebo.paused
        response.max_update_rate = 1e9 / self._gazebo.world.step_ns
        gravity = response.gravity
        gravity.x, gravity.y, gravity.z = self._gazebo.world.gravity
        return "GetPhysicsProperties: got properties"

    @answers("set_physics_properties", "gazebo_msgs/SetPhysicsProperties")
    def _set_physics(self, request: Any, _response: Any) -> str:
        step_s = self._gazebo.world.step_ns * 1e-9
        if request.time_step and abs(request.time_step - step_s) > 1e-12:
            raise SimkitError(
                f"SetPhysicsProperties: steps are of {step_s:g} s here; write <max_step_size> in the world file"
            )
        self._gazebo.world.gravity = vector_of(request.gravity)
        return "physics engine updated"
