"""Services that bring models in and take them out."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from simkit.gazebo.models import Spawned
from simkit.gazebo.poses import transform_of_message
from simkit.gazebo.server import Gazebo
from simkit.gazebo.services.service import GazeboService, model_of

SPAWNED = "SpawnModel: Successfully spawned entity"
DELETED = "DeleteModel: successfully deleted model"


class SpawnServices:
    """Services that bring models in and take them out.

    Args:
        gazebo: The world.
    """

    def __init__(self, gazebo: Gazebo) -> None:
        self._gazebo = gazebo

    def services(self) -> list[GazeboService]:
        """All of them."""
        spawn = "gazebo_msgs/SpawnModel"
        return [
            GazeboService(
                name="spawn_urdf_model",
                type_name=spawn,
                answer=self._spawning(self._gazebo.spawn_urdf),
            ),
            GazeboService(
                name="spawn_sdf_model",
                type_name=spawn,
                answer=self._spawning(self._gazebo.spawn_sdf),
            ),
            GazeboService(
                name="delete_model", type_name="gazebo_msgs/DeleteModel", answer=self._delete
            ),
        ]

    @staticmethod
    def _spawning(spawn: Callable[..., Spawned]) -> Callable[[Any, Any], str]:
        def answer(request: Any, _response: Any) -> str:
            spawn(
                request.model_xml,
                name=request.model_name,
                pose=transform_of_message(request.initial_pose),
                namespace=request.robot_namespace or None,
                reference_frame=request.reference_frame,
            )
            return SPAWNED

        return answer

    def _delete(self, request: Any, _response: Any) -> str:
        model_of(self._gazebo, request.model_name, "DeleteModel")
        self._gazebo.delete(request.model_name)
        return DELETED
