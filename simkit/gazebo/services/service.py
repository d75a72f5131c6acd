"""Groups of services, how they answer, and the models and links that requests name."""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import Any

from simkit.errors import SimkitError
from simkit.gazebo.server import Gazebo
from simkit.msgs import Message, service_class
from simkit.physics import Model

Answer = Callable[[Any, Any, Any], str]
"""A method that, given the request and an empty response, does it, fills the response, and returns the status."""


def answers(name: str, type_name: str) -> Callable[[Answer], Answer]:
    """Marks the method that answers a service.

    Args:
        name: Name of the service, below `/gazebo`.
        type_name: Its type.
    """

    def mark(method: Answer) -> Answer:
        method.service = (name, type_name)  # type: ignore[attr-defined]
        return method

    return mark


class ServiceGroup:
    """Services of one subject: the methods that `answers` marks.

    Args:
        gazebo: The world.
    """

    def __init__(self, gazebo: Gazebo) -> None:
        self._gazebo = gazebo

    def offer(self) -> None:
        """Offer them by the node of the world."""
        for (name, type_name), method in self.marked():
            kind = service_class(type_name)
            answer = functools.partial(_answered, kind, functools.partial(method, self))
            self._gazebo.node.advertise_service(f"/gazebo/{name}", kind, answer)

    @classmethod
    def marked(cls) -> list[tuple[tuple[str, str], Answer]]:
        """Names and types of its services, with their methods."""
        return [(one.service, one) for one in vars(cls).values() if hasattr(one, "service")]


def _answered(kind: Any, answer: Callable[[Any, Any], str], request: Any) -> Message:
    """The response to a request; what goes wrong is its status."""
    response: Any = kind._response_class()
    has_status = hasattr(response, "status_message")
    try:
        status, success = answer(request, response), True
    except SimkitError as error:
        status, success = str(error), False
    if has_status:
        response.success, response.status_message = success, status
    found: Message = response
    return found


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
