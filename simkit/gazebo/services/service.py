"""One service, and how it answers."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from simkit.errors import SimkitError
from simkit.gazebo.server import Gazebo
from simkit.msgs import Message, service_class
from simkit.physics import Model


@dataclass(frozen=True, slots=True, kw_only=True)
class GazeboService:
    """One service below `/gazebo`."""

    name: str
    """Its name there."""
    type_name: str
    """Its type."""
    answer: Callable[[Any, Any], str]
    """Given the request and an empty response, does it, fills the response, and returns the status."""

    def handle(self, request: Any) -> Message:
        """Do what a request asks for; what goes wrong is told in the status."""
        response: Any = service_class(self.type_name)._response_class()
        has_status = hasattr(response, "status_message")
        try:
            status = self.answer(request, response)
        except SimkitError as error:
            if has_status:
                response.success = False
                response.status_message = str(error)
            found: Message = response
            return found
        if has_status:
            response.success = True
            response.status_message = status
        answered: Message = response
        return answered


def model_of(gazebo: Gazebo, name: str, service: str) -> Model:
    """A model by name.

    Raises:
        SimkitError: There is none; names those that there are.
    """
    models = gazebo.world.models
    if name not in models:
        raise SimkitError(
            f"{service}: model [{name}] does not exist; here are: {', '.join(models)}"
        )
    return models[name]


def link_of(gazebo: Gazebo, name: str, service: str) -> tuple[Model, str]:
    """A link by `model::link`, or by its own name if only one model has such a link.

    Raises:
        SimkitError: There is none, or more than one.
    """
    model_name, separator, link = name.partition("::")
    if separator:
        model = gazebo.world.models.get(model_name)
        if model is not None and link in model.links:
            return model, link
        found = []
    else:
        found = [one for one in gazebo.world.models.values() if name in one.links]
    if len(found) == 1:
        return found[0], name
    why = "is in several models: write model::link" if found else "does not exist"
    known = [f"{one.name}::{each}" for one in gazebo.world.models.values() for each in one.links]
    raise SimkitError(f"{service}: link [{name}] {why}; links here: {', '.join(known[:12])}")
