"""The front door: `Simulation` has time, nodes, the graph and TF, and the parts beside it have a simulation.

`simulation` is the class and the one place where the methods of its parts become methods of a `Simulation`;
`graph_client`, `launcher`, `gazebo_starter`, `recorder`, `view`, `world_window`, `widgets` are the parts. They are
light: physics and pictures are loaded when they are asked for.
"""

from simkit.simulation.open_simulations import newest_simulation
from simkit.simulation.simulation import Simulation

__all__ = ["Simulation", "newest_simulation"]
