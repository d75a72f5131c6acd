"""The ground: Gazebo's model `ground_plane`, a plane without end at z = 0 that nothing moves."""

from __future__ import annotations

import functools

from simkit.physics.plan import ModelPlan
from simkit.physics.sdf import plan_model, read_model_text
from simkit.physics.sdf.library import BUILT_IN

GROUND = "ground_plane"
"""Its name."""


@functools.cache
def ground_plan() -> ModelPlan:
    """The plan of the ground.

    Its friction is 100: of two that touch the smaller coefficient counts, so that of the robot does.
    """
    model, _ = read_model_text(BUILT_IN[GROUND], file=f"model://{GROUND}/model.sdf")
    return plan_model(model)
