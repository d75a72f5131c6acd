"""The services of gazebo_ros, below `/gazebo`.

Source: gazebo_ros `gazebo_ros_api_plugin.cpp`: names, types and the texts of `status_message`.
"""

from __future__ import annotations

from simkit.gazebo.server import Gazebo
from simkit.gazebo.services.links import LinkServices
from simkit.gazebo.services.models import ModelServices
from simkit.gazebo.services.pushes import PushServices
from simkit.gazebo.services.spawn import SpawnServices
from simkit.gazebo.services.worlds import WorldServices
from simkit.msgs import service_class

GROUPS = (SpawnServices, ModelServices, LinkServices, PushServices, WorldServices)
"""All services, by what they are about."""


def offer_services(gazebo: Gazebo) -> None:
    """Offer all of them, by the node of the world."""
    for group in GROUPS:
        for service in group(gazebo).services():
            gazebo.node.advertise_service(
                f"/gazebo/{service.name}", service_class(service.type_name), service.handle
            )


__all__ = ["GROUPS", "offer_services"]
