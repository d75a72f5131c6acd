"""Which links touch anything, and what they bear."""

from __future__ import annotations

from collections.abc import Iterable

from simkit.gazebo.watching.watcher import Scene


def load_share(scene: Scene, bodies: Iterable[str]) -> float | None:
    """The share of the weight of a model that some of its bodies bear; None if it weighs nothing.

    Args:
        scene: The model.
        bodies: Names of the bodies.
    """
    model, world = scene.model, scene.gazebo.world
    weight = -model.mass * world.gravity[2]
    if weight <= 0.0:
        return None
    wanted, borne = set(bodies), 0.0
    for contact in world.contacts():
        for side, sign in ((contact.first, 1.0), (contact.second, -1.0)):
            other = contact.second if side is contact.first else contact.first
            if side.model == model.name and other.model != model.name and side.body in wanted:
                borne += sign * contact.force[2]
    return max(0.0, borne) / weight


def touching(scene: Scene) -> set[str]:
    """The bodies of a model that touched something else in the last step."""
    name = scene.model.name
    found = set()
    for contact in scene.gazebo.world.contacts():
        for side, other in ((contact.first, contact.second), (contact.second, contact.first)):
            if side.model == name and other.model != name:
                found.add(side.body)
    return found
