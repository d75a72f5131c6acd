"""What there is to see of the world of a simulation: Gazebo's window, and replays of it."""

from __future__ import annotations

import weakref
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING

from simkit.errors import SimkitError

if TYPE_CHECKING:
    from simkit.gazebo import Gazebo
    from simkit.graph.recording import Recording
    from simkit.simulation.simulation import Simulation
    from simkit.viz import LiveWorld, WorldReplay, WorldSettings, WorldTape, WorldView


class WorldWindow:
    """The part of a `Simulation` that shows its world as Gazebo's window does.

    Args:
        sim: The simulation.
    """

    def __init__(self, sim: Simulation) -> None:
        self._sim: Simulation = weakref.proxy(sim)

    def gzclient(
        self,
        look_at: str = "",
        *,
        models: bool = True,
        collisions: bool = False,
        contacts: bool = False,
        center_of_mass: bool = False,
        inertias: bool = False,
        joints: bool = False,
        link_frames: bool = False,
        scans: bool = True,
        grid: bool = True,
        transparent: bool | None = None,
        live: bool = False,
    ) -> WorldView | LiveWorld:
        """The window of Gazebo: all models, to turn and zoom, with what its menu View shows.

        A link has the colour of its `<gazebo><material>`. One without it is grey in Gazebo; here it
        has the colour that the URDF gives to RViz. Links without mass are not in Gazebo's world.

        Args:
            look_at: Model that the camera looks at; all of them if empty.
            models: Whether what is seen of the models is shown at first.
            collisions: The shapes that others touch, orange.
            contacts: Where models touch, and the forces there, green; an arrow as long as the heaviest model is its weight.
            center_of_mass: For each link a ball of lead that is as heavy, red.
            inertias: For each link a box that is as hard to turn, purple.
            joints: Axes of the joints, yellow.
            link_frames: Axes and names of the links.
            scans: What lasers see, blue.
            grid: The grid on the ground.
            transparent: Whether one sees through the models; if None, when something inside of them is shown.
            live: Whether the view follows the simulation, for which this process serves it on 127.0.0.1.

        Raises:
            SimkitError: There is no world, or no model of that name.
        """
        from simkit.viz import WorldSettings, WorldSource, WorldView

        settings = WorldSettings(
            models=models,
            collisions=collisions,
            contacts=contacts,
            center_of_mass=center_of_mass,
            inertias=inertias,
            joints=joints,
            link_frames=link_frames,
            scans=scans,
            grid=grid,
            transparent=transparent,
            look_at=look_at,
        )
        if live:
            return self.live(settings)
        return WorldView(WorldSource(world_to_see(self._sim), settings).scene())

    def gzclient_replay(
        self,
        tape: WorldTape,
        look_at: str = "",
        *,
        trail: str | Iterable[str] = (),
        odometry: Recording | None = None,
        collisions: bool = False,
        contacts: bool = False,
        center_of_mass: bool = False,
        inertias: bool = False,
        joints: bool = False,
        link_frames: bool = False,
        scans: bool = True,
        transparent: bool | None = None,
    ) -> WorldReplay:
        """What the window of Gazebo showed during a recording; `save("run.html")` keeps it.

        Args:
            tape: What `sim.record_world()` gave; it goes on.
            look_at: Model that the camera looks at, wherever it went; all of them if empty.
            trail: Links that leave a trail: "car::base_link", or "car" for its root link.
            odometry: What `sim.record(["/odom"])` gave: where the robot believes that it went, from where it began.
            collisions: As in `gzclient`, and so are all others.
            contacts: Whether contacts are in the replay.
            center_of_mass: Centres of mass.
            inertias: Boxes of equal inertia.
            joints: Axes of the joints.
            link_frames: Axes and names of the links.
            scans: Whether what lasers see is in the replay.
            transparent: Whether one sees through the models.

        Raises:
            UnknownNameError: There was no such link, or no model of that name.
        """
        from simkit.viz import WorldReplay, WorldSettings

        settings = WorldSettings(
            collisions=collisions,
            contacts=contacts,
            center_of_mass=center_of_mass,
            inertias=inertias,
            joints=joints,
            link_frames=link_frames,
            scans=scans,
            transparent=transparent,
            look_at=look_at,
        )
        trails = [trail] if isinstance(trail, str) else list(trail)
        return WorldReplay(tape, settings, trails=trails, odometry=odometry)

    def picture(self) -> WorldView:
        """The world as it is now.

        Raises:
            SimkitError: There is no world.
        """
        from simkit.viz import WorldSettings, WorldSource, WorldView

        return WorldView(WorldSource(world_to_see(self._sim), WorldSettings()).scene())

    def live(
        self,
        settings: WorldSettings | None = None,
        *,
        is_over: Callable[[], bool] = lambda: False,
    ) -> LiveWorld:
        """The world as a page that follows it.

        Args:
            settings: What is to be seen.
            is_over: Whether the page is no longer needed.

        Raises:
            SimkitError: There is no world.
        """
        from simkit.viz import LiveWorld, WorldSettings, WorldSource

        gazebo = world_to_see(self._sim)
        source = WorldSource(gazebo, settings or WorldSettings(), is_live=True)
        view = LiveWorld(source, is_over=lambda: is_over() or not gazebo.node.alive)
        self._sim.view.add(view.refresh, view.close)
        return view


def world_to_see(sim: Simulation) -> Gazebo:
    """The world of a simulation.

    Raises:
        SimkitError: There is none.
    """
    if not sim.has_world:
        raise SimkitError(
            "there is no world to see: roslaunch gazebo_ros empty_world.launch starts one (in Python: sim.gazebo)"
        )
    return sim.gazebo
