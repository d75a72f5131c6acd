"""The window of Gazebo at one moment: a view to turn, in a notebook or as a file, and a still picture."""

from __future__ import annotations

from simkit.viz.live_rviz import LiveRviz
from simkit.viz.rviz_view import RvizView


class WorldView(RvizView):
    """The models of a world at one moment; it does not change afterwards.

    In a notebook it is drawn in place, to be turned by mouse, finger or arrow keys. It needs no
    server and no network. `save("world.png")` and `save("world.html")` keep it.

    Args:
        scene: What it shows.
    """

    def __repr__(self) -> str:
        return f"WorldView({self.scene.headline!r})"


class LiveWorld(LiveRviz):
    """The window of Gazebo as it is now; see `LiveRviz`."""
