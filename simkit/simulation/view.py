"""What there is to see of a simulation: pictures, views that are live, replays; and who keeps them up to date."""

from __future__ import annotations

import weakref
from collections.abc import Callable, Iterable, Mapping
from typing import TYPE_CHECKING

from simkit.errors import SimkitError
from simkit.msgs import Time

if TYPE_CHECKING:
    from simkit.graph.process import ScriptNode
    from simkit.graph.recording import Recording
    from simkit.nodes.builtin import RunningBuiltin
    from simkit.nodes.turtlesim import TurtlesimNode
    from simkit.simulation.simulation import Simulation
    from simkit.viz import (
        FramesPicture,
        JointSliders,
        LiveRviz,
        LiveWorld,
        RvizReplay,
        RvizSettings,
        RvizView,
        SceneSource,
        TopicListeners,
        TurtlesimView,
        WorldView,
    )
    from simkit.viz.turtlesim.view import LiveTurtlesim


class View:
    """The part of a `Simulation` that shows; pictures are made when they are asked for.

    Args:
        sim: The simulation.
    """

    def __init__(self, sim: Simulation) -> None:
        self._sim: Simulation = weakref.proxy(sim)
        self._refreshers: list[Callable[[], None]] = []
        self._closers: list[Callable[[], None]] = []
        self._listeners: TopicListeners | None = None

    def add(self, refresh: Callable[[], None], close: Callable[[], None] | None = None) -> None:
        """Keep a view up to date from now on.

        Args:
            refresh: Called whenever virtual time has passed.
            close: Called when the simulation is closed.
        """
        self._refreshers.append(refresh)
        if close is not None:
            self._closers.append(close)

    def refresh(self) -> None:
        """Bring all views that are live up to date."""
        for refresh in self._refreshers:
            refresh()

    def close(self) -> None:
        """Close all views that are served."""
        while self._closers:
            self._closers.pop()()

    def view_frames(self) -> FramesPicture:
        """The tree of frames as a drawing, with the facts of each edge; `save("frames.pdf")` keeps it."""
        from simkit.viz import FramesPicture

        return FramesPicture(self._sim.tf, now=self._sim.now)

    def rviz(
        self,
        fixed_frame: str = "world",
        *,
        topics: Iterable[str] | Mapping[str, str] = (),
        keep: int = 100,
        time: Time | None = None,
        robot_model: str | None = "visual",
        alpha: float = 1.0,
        show_tf: bool = True,
        show_grid: bool = True,
        description: str | Iterable[str] | Mapping[str, str] = "/robot_description",
        live: bool = False,
    ) -> RvizView | LiveRviz:
        """Frames, robot and topics in 3D, to turn and zoom.

        A topic is heard from the first view of it on; of what was said before, the last message is shown.

        Args:
            fixed_frame: Frame that stands still; the others are drawn in it.
            topics: Topics to show, of sensor_msgs/LaserScan, nav_msgs/Odometry or nav_msgs/Path; names, or names with
                types for topics that are still to come.
            keep: So many arrows of odometry are kept.
            time: Moment to show; the latest if None.
            robot_model: Which shapes of the robot are seen at first: "visual", "collision", or None for no robot.
            alpha: Opacity of the robot, from 0 to 1.
            show_tf: Whether axes and names of the frames are seen at first.
            show_grid: Whether the grid is seen at first.
            description: Parameter with the URDF of the robot. For several robots, or one whose frames have a
                tf_prefix, such parameters with the prefix of each: `{"/left/robot_description": "left"}`.
            live: Whether the view follows the simulation, for which this process serves it on 127.0.0.1.

        Raises:
            UnknownNameError: A topic is not in use and no type is given.
            SimkitError: No display shows messages of a topic's type.
        """
        from simkit.viz import RvizSettings, RvizView, display_of, robot_displays

        settings = RvizSettings(
            fixed_frame=fixed_frame,
            time=time or Time(0),
            robot_model=robot_model,
            alpha=alpha,
            show_tf=show_tf,
            show_grid=show_grid,
            robots=robot_displays(description),
            topics=tuple(
                display_of(name, cls._type, keep=keep)
                for name, cls in self._sim.graph_client.message_classes(topics).items()
            ),
        )
        if live:
            return self.live_rviz(settings)
        return RvizView(self.scene_source(settings).scene())

    def rviz_replay(
        self,
        recording: Recording,
        fixed_frame: str = "world",
        *,
        robot_model: str | None = "visual",
        alpha: float = 1.0,
        description: str | Iterable[str] | Mapping[str, str] = "/robot_description",
        keep: int = 100,
    ) -> RvizReplay:
        """What RViz showed during a recording, to be played again; `save("run.html")` keeps it.

        Recorded laser scans, odometry and paths are shown as well.

        Args:
            recording: Of /tf and /tf_static, as `sim.record(["/tf", "/tf_static", "/scan"])` makes it.
            fixed_frame: Frame that stands still; the others are drawn in it.
            robot_model: Which shapes of the robot are seen at first: "visual", "collision", or None for no robot.
            alpha: Opacity of the robot, from 0 to 1.
            description: As for `rviz`.
            keep: So many arrows of odometry are kept.
        """
        from simkit.viz import RvizReplay, RvizSettings, displays_of, robot_displays

        settings = RvizSettings(
            fixed_frame=fixed_frame,
            robot_model=robot_model,
            alpha=alpha,
            robots=robot_displays(description),
            topics=displays_of(recording.types(), keep=keep),
        )
        robot = self.scene_source(settings).robot()
        return RvizReplay(recording, settings, robot=robot)

    @property
    def turtlesim(self) -> TurtlesimView:
        """The turtlesim that runs here: `picture()`, `replay()`, `live()`.

        Raises:
            SimkitError: None runs.
        """
        from simkit.nodes.turtlesim import TurtlesimNode
        from simkit.viz import TurtlesimView

        for builtin in reversed(self._sim.builtins):
            if isinstance(builtin.program, TurtlesimNode) and builtin.alive:
                return TurtlesimView(builtin.program, add_view=self.add)
        raise SimkitError("no turtlesim runs: sim.rosrun('turtlesim', 'turtlesim_node')")

    def window_of(
        self, node: ScriptNode | RunningBuiltin
    ) -> RvizView | WorldView | JointSliders | None:
        """What rviz or gzclient shows, or the sliders of joint_state_publisher_gui; None for other nodes.

        A gzclient that goes on is one of a launch file: it has said how its window is opened.

        Args:
            node: What `rosrun` answered.

        Raises:
            SimkitError: It is gzclient, and there is no world.
        """
        from simkit.nodes.gzclient import GzclientProgram
        from simkit.nodes.joint_state_publisher import JointStatePublisherGui
        from simkit.nodes.rviz import RvizProgram
        from simkit.viz import RvizView

        program = getattr(node, "program", None)
        if isinstance(program, RvizProgram):
            return RvizView(self.scene_source(program.settings(self._sim.packages)).scene())
        if isinstance(program, GzclientProgram) and not node.alive:
            return self._sim.world_window.picture()
        if isinstance(program, JointStatePublisherGui) and node.alive:
            return self._sim.joint_sliders(node.name)
        return None

    def serve_window_of(
        self, node: ScriptNode | RunningBuiltin
    ) -> LiveRviz | LiveWorld | LiveTurtlesim | None:
        """Serve the window of an rviz, a gzclient or a turtlesim as a page that follows the simulation.

        The page ends with the node, which prints its address. A joint_state_publisher_gui has no page: it listens to a
        topic, and prints which line moves a joint.

        Args:
            node: What `rosrun` answered.

        Raises:
            SimkitError: It is gzclient, and there is no world.
        """
        from simkit.nodes.gzclient import GzclientProgram
        from simkit.nodes.joint_state_publisher import JointStatePublisherGui
        from simkit.nodes.rviz import RvizProgram
        from simkit.nodes.turtlesim import TurtlesimNode

        program = getattr(node, "program", None)

        def is_over() -> bool:
            return not node.alive

        page: LiveRviz | LiveWorld | LiveTurtlesim
        if isinstance(program, TurtlesimNode):
            page = self._live_turtlesim(program, is_over=is_over)
        elif isinstance(program, RvizProgram):
            page = self.live_rviz(program.settings(self._sim.packages), is_over=is_over)
        elif isinstance(program, GzclientProgram):
            page = self._sim.world_window.live(is_over=is_over)
        else:
            if isinstance(program, JointStatePublisherGui):
                program.listen()
            return None
        program.show_address(page.url)
        return page

    def _live_turtlesim(
        self, program: TurtlesimNode, *, is_over: Callable[[], bool]
    ) -> LiveTurtlesim:
        from simkit.viz.turtlesim.view import LiveTurtlesim

        page = LiveTurtlesim(program.frame, is_over=is_over)
        self.add(page.refresh, page.close)
        return page

    def live_rviz(
        self, settings: RvizSettings, *, is_over: Callable[[], bool] = lambda: False
    ) -> LiveRviz:
        """A view that follows the simulation.

        Args:
            settings: What is to be seen.
            is_over: Asked before each look; the view ends when it holds.
        """
        from simkit.viz import LiveRviz

        view = LiveRviz(self.scene_source(settings, with_room=True), is_over=is_over)
        self.add(view.refresh, view.close)
        return view

    def scene_source(self, settings: RvizSettings, *, with_room: bool = False) -> SceneSource:
        """Where a view gets what it shows.

        Args:
            settings: What is to be seen.
            with_room: Whether the scene has room for more than there is now.
        """
        from simkit.viz import SceneSource, TopicListeners

        self._listeners = self._listeners or TopicListeners(self._sim.node, self._sim.tf)
        return SceneSource(
            settings,
            listeners=self._listeners,
            buffer=self._sim.tf,
            parameters=self._sim.graph.params,
            packages=self._sim.packages,
            with_room=with_room,
        )
