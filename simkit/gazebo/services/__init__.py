"""The services of gazebo_ros, below `/gazebo`.

Source: gazebo_ros `gazebo_ros_api_plugin.cpp`: names, types and the texts of `status_message`.
"""

from __future__ import annotations

from simkit.gazebo.server import Gazebo
from simkit.gazebo.services.models import LinkServices, ModelServices
from simkit.gazebo.services.pushes import PushServices
from simkit.gazebo.services.worlds import SpawnServices, WorldServices

GROUPS = (SpawnServices, ModelServices, LinkServices, PushServices, WorldServices)
"""All services, by what they are about."""


def offer_services(gazebo: Gazebo) -> None:
    """Offer all of them, by the node of the world."""
    for group in GROUPS:
        group(gazebo).offer()


__all__ = ["GROUPS", "offer_services"]
