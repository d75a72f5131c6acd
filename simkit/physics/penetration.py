"""Penetration: what is put into something else comes out of it.

The engine pushes bodies that reach into each other apart at 1 mm/s: a robot that is spawned with its
wheels 10 cm below the ground would take 100 s to come up. Gazebo shoots it out within a few steps.
Here, each step moves a free model by a fifth of its greatest depth, until no contact is deeper than
0.1 mm: it is out after some 30 ms, at rest. It is done after something was put somewhere, and to
what falls: a car that lands at 4 m/s is 4 mm deep in the ground before the engine knows.

Source: the share is the error reduction of Gazebo's ODE, 0.2 per step.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from simkit.physics.contact import Owner, shape_names
from simkit.physics.model import Model

DEEP = 1e-4
"""A contact that is deeper [m] is not one of things that rest on each other."""
FALLING = 0.75
"""What falls faster [m/s] may be deep in something within a step."""
SHARE = 0.2
"""So much of the depth is taken away in a step."""
LONGEST = 200
"""After so many steps what still sticks in something is left there, e.g. between two walls."""


def lift(result: Any, owners: Mapping[str, Owner], models: Mapping[str, Model]) -> bool:
    """Move free models out of what they stick in, a bit; whether there is more to do.

    Args:
        result: The contacts of the last step, as the engine gives them.
        owners: What its shapes are.
        models: The models of the world.
    """
    deepest: dict[str, tuple[float, Any]] = {}
    for contact in result.getContacts():
        depth = contact.penetrationDepth
        if depth <= DEEP:
            continue
        for name, sign in zip(shape_names(contact), (1.0, -1.0), strict=True):
            model = owners[name].model
            if models[model].is_free and depth > deepest.get(model, (0.0, None))[0]:
                deepest[model] = (depth, sign * np.asarray(contact.normal))
    for model, (depth, direction) in deepest.items():
        models[model].shift(SHARE * depth * direction)
    return bool(deepest)
