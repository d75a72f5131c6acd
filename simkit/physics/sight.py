"""Sight: the shapes of a model as rays meet them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from simkit.physics.plan import ShapePlan
from simkit.physics.poses import isometry
from simkit.physics.rays import Target
from simkit.physics.skeleton import Built


class Sight:
    """What rays can hit of one model.

    Args:
        built: The model in the engine.
    """

    def __init__(self, built: Built) -> None:
        self.labels = tuple(built.shapes)
        """Names of its shapes in the engine, in the order of the targets."""
        self._shapes = [self._seen(node, plan) for node, plan in built.shapes.values()]

    def targets(self) -> Iterator[Target]:
        """Its shapes where they are now."""
        for shape, frame, inner in self._shapes:
            pose = frame.getWorldTransform()
            matrix = (pose if inner is None else pose.multiply(inner)).matrix()
            yield Target(shape, matrix[:3, :3], matrix[:3, 3])

    @staticmethod
    def _seen(node: Any, plan: ShapePlan) -> tuple[Any, Any, Any]:
        """What is seen, the frame of the engine that it is known in, and where it is there."""
        if plan.mesh is None:
            return plan.solid, node, None
        return plan.mesh, node.getBodyNodePtr(), isometry(plan.mesh_frame)
