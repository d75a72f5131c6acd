"""The services of gazebo_ros, below `/gazebo`.

Source: gazebo_ros `gazebo_ros_api_plugin.cpp`: names, types and the texts of `status_message`.
"""

from __future__ import annotations

from simkit.gazebo.server import Gazebo
from simkit.gazebo.services import links, models, pushes, spawning, worlds
from simkit.msgs import service_class


def offer_services(gazebo: Gazebo) -> None:
    """Offer all of them, by the node of the world."""
    for group in (spawning, models, links, pushes, worlds):
        for service in group.services(gazebo):
            gazebo.node.advertise_service(
                f"/gazebo/{service.name}", service_class(service.type_name), service.handle
            )


__all__ = ["offer_services"]
