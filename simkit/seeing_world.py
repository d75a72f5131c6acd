"""What there is to see of the world of a simulation: Gazebo's window, recordings of the world, replays."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING

from simkit.errors import SimkitError
from simkit.graph.process import ScriptNode
from simkit.running import RunningBuiltin
from simkit.seeing import Seeing

if TYPE_CHECKING:
    from simkit.gazebo import Gazebo
    from simkit.recording import Recording
    from simkit.viz import LiveRviz, RvizView
    from simkit.viz.turtlesim.page import LiveTurtlesim
    from simkit.viz.world import LiveWorld, WorldReplay, WorldSettings, WorldTape, WorldView


class SeeingWorld(Seeing):
    """The part of `Simulation` that shows its world; pictures are made when they are asked for."""

    @property
    def has_world(self) -> bool:
        """Whether a world is there already."""
        raise NotImplementedError

    @property
    def gazebo(self) -> Gazebo:
        """The world."""
        raise NotImplementedError

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
        from simkit.viz.world import WorldSettings, WorldSource, WorldView

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
            return self._live_world(settings)
        return WorldView(WorldSource(self._world_to_see(), settings).scene())

    def record_world(self, *, rate: float = 30.0) -> WorldTape:
        """Record where all links and joints are from now on, what touches, and what lasers see.

        Args:
            rate: How often to look [Hz of virtual time], rounded to whole milliseconds.

        Returns:
            A recording with `link(model, link)`, `joint(model, joint)`, `contacts`, `scans`, `stop()`.

        Raises:
            SimkitError: There is no world, or the rate makes no sense.
        """
        from simkit.viz.world import WorldTape

        gazebo = self._world_to_see()
        return WorldTape(gazebo, gazebo.node, rate=rate)

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
        """What the window of Gazebo showed during a recording, to be played again; `save("run.html")` keeps it.

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
        from simkit.viz.world import WorldReplay, WorldSettings

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

    def window_of(self, node: ScriptNode | RunningBuiltin) -> RvizView | None:
        """What rviz or gzclient shows, if this is one; None for other nodes.

        A gzclient that goes on is one of a launch file: it has said how its window is opened.

        Args:
            node: What `rosrun` answered.

        Raises:
            SimkitError: It is gzclient, and there is no world.
        """
        from simkit.nodes.gzclient import GzclientProgram

        if not isinstance(getattr(node, "program", None), GzclientProgram):
            return super().window_of(node)
        if node.alive:
            return None
        from simkit.viz.world import WorldSettings, WorldSource, WorldView

        return WorldView(WorldSource(self._world_to_see(), WorldSettings()).scene())

    def serve_window_of(self, node: ScriptNode | RunningBuiltin) -> LiveRviz | LiveTurtlesim | None:
        """The same as a page that follows the simulation until the node ends; the node prints its address.

        Args:
            node: What `rosrun` answered.

        Raises:
            SimkitError: It is gzclient, and there is no world.
        """
        from simkit.nodes.gzclient import GzclientProgram

        program = getattr(node, "program", None)
        if not isinstance(program, GzclientProgram):
            return super().serve_window_of(node)
        from simkit.viz.world import WorldSettings

        view = self._live_world(WorldSettings(), is_over=lambda: not node.alive)
        program.tell(view.url)
        return view

    def _live_world(
        self, settings: WorldSettings, *, is_over: Callable[[], bool] = lambda: False
    ) -> LiveWorld:
        from simkit.viz.world import LiveWorld, WorldSource

        gazebo = self._world_to_see()
        source = WorldSource(gazebo, settings, is_live=True)
        view = LiveWorld(source, is_over=lambda: is_over() or not gazebo.node.alive)
        self._views.append(view.refresh)
        self._closers.append(view.close)
        return view

    def _world_to_see(self) -> Gazebo:
        if not self.has_world:
            raise SimkitError(
                "there is no world to see: roslaunch gazebo_ros empty_world.launch starts one (in Python: sim.gazebo)"
            )
        return self.gazebo
