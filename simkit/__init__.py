"""simkit: ROS 1 for learning - graph, TF, turtlesim, URDF and simulation - with nothing but pip.

Start with `Simulation`.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from simkit.errors import SimkitError, UnknownNameError

if TYPE_CHECKING:
    from simkit.simulation import Simulation

__all__ = ["SimkitError", "Simulation", "UnknownNameError", "__version__"]
__version__ = "0.1.0"


def __getattr__(name: str) -> Any:
    # Loaded when first used: `import simkit.msgs` in a node process needs nothing of it.
    if name == "Simulation":
        from simkit.simulation import Simulation

        return Simulation
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def load_ipython_extension(ipython: Any) -> None:
    """What `%load_ext simkit` calls: the lines `%rosrun`, `%rostopic` and their kin."""
    from simkit.notebook import register

    register(ipython)
