"""Methods of a part of a `Simulation` as methods of the simulation."""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Concatenate, ParamSpec, TypeVar

if TYPE_CHECKING:
    from simkit.simulation.simulation import Simulation

P = ParamSpec("P")
R = TypeVar("R")


def delegate(
    part: str, method: Callable[Concatenate[Any, P], R], *, is_start: bool = False
) -> Callable[Concatenate[Simulation, P], R]:
    """A method of a part as a method of the simulation: the same name, signature and docstring.

    Args:
        part: Attribute of the simulation that holds the part.
        method: Method of the part's class.
        is_start: Whether it starts what `Simulation.reset` starts again.
    """
    name = method.__name__

    @functools.wraps(method)
    def delegated(self: Simulation, /, *args: P.args, **kwargs: P.kwargs) -> R:
        answer: R = getattr(getattr(self, part), name)(*args, **kwargs)
        if is_start:
            self.note_start(name, *args, **kwargs)
        return answer

    return delegated
