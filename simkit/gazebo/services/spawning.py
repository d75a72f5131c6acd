"""Services that bring models in and take them out."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from simkit.gazebo.models import Spawned
from simkit.gazebo.poses import placement_of
from simkit.gazebo.server import Gazebo
from simkit.gazebo.services.service import Service, model_of

SPAWNED = "SpawnModel: Successfully spawned entity"
DELETED = "DeleteModel: successfully deleted model"


def services(gazebo: Gazebo) -> list[Service]:
    """The services of this group."""

    def spawning(spawn: Callable[..., Spawned]) -> Callable[[Any, Any], str]:
        def answer(request: Any, _response: Any) -> str:
            spawn(
                request.model_xml,
                name=request.model_name,
                pose=placement_of(request.initial_pose),
                namespace=request.robot_namespace or None,
                reference_frame=request.reference_frame,
            )
            return SPAWNED

        return answer

    def delete(request: Any, _response: Any) -> str:
        model_of(gazebo, request.model_name, "DeleteModel")
        gazebo.delete(request.model_name)
        return DELETED

    spawn = "gazebo_msgs/SpawnModel"
    return [
        Service(name="spawn_urdf_model", type_name=spawn, answer=spawning(gazebo.spawn_urdf)),
        Service(name="spawn_sdf_model", type_name=spawn, answer=spawning(gazebo.spawn_sdf)),
        Service(name="delete_model", type_name="gazebo_msgs/DeleteModel", answer=delete),
    ]
