"""What there is to see of a simulation: texts of tf's tools, pictures, plots, replays."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import TYPE_CHECKING

from simkit.errors import SimkitError
from simkit.msgs import Message, Time
from simkit.steering import while_it_lives
from simkit.tf import Buffer, echo_text

if TYPE_CHECKING:
    from simkit.graph import Graph, Node
    from simkit.graph.process import ScriptNode
    from simkit.nodes.joint_state_publisher import JointStatePublisherGui
    from simkit.nodes.turtlesim import TurtlesimNode
    from simkit.packages import PackagePath
    from simkit.recording import Recording
    from simkit.running import RunningBuiltin
    from simkit.viz import (
        FramesPicture,
        JointSliders,
        LiveRviz,
        RvizEars,
        RvizReplay,
        RvizSettings,
        RvizView,
        SceneSource,
        TransformPlot,
        TurtlesimView,
    )
    from simkit.viz.turtlesim.page import LiveTurtlesim


class Seeing:
    """The part of `Simulation` that shows; pictures are made when they are asked for."""

    graph: Graph
    packages: PackagePath
    tf: Buffer
    _builtins: list[RunningBuiltin]
    _views: list[Callable[[], None]]
    _closers: list[Callable[[], None]]
    _sliders: list[JointSliders]
    _node: Node
    _ears: RvizEars | None = None

    @property
    def now(self) -> Time:
        """Virtual time."""
        raise NotImplementedError

    def run(self, seconds: float) -> None:
        """Let virtual time pass [s]."""
        raise NotImplementedError

    def _message_classes(
        self, topics: Iterable[str] | Mapping[str, str]
    ) -> dict[str, type[Message]]:
        raise NotImplementedError

    def tf_echo(self, source: str, target: str, *, precision: int = 3) -> str:
        """What `rosrun tf tf_echo source target` prints: where `target` is, seen from `source`."""
        return echo_text(self.tf, source, target, self.now, precision=precision)

    def view_frames(self) -> FramesPicture:
        """The tree of frames as a drawing, with the facts of each edge; `save("frames.pdf")` keeps it."""
        from simkit.viz import FramesPicture

        return FramesPicture(self.tf, now=self.now)

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
                for name, cls in self._message_classes(topics).items()
            ),
        )
        if live:
            return self._live_rviz(settings)
        return RvizView(self._scene_source(settings).scene())

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
        robot = self._scene_source(settings).robot()
        return RvizReplay(recording, settings, robot=robot)

    def tf_plot(
        self, target: str, source: str, *, recording: Recording | None = None
    ) -> TransformPlot:
        """Where `source` was, seen from `target`, over virtual time.

        Args:
            target: Frame to express it in.
            source: Frame to follow.
            recording: Of /tf and /tf_static; the last ten seconds of the buffer if None.
        """
        from simkit.viz import TransformPlot

        data = self.tf if recording is None else recording
        return TransformPlot(data, target=target, source=source)

    def joint_sliders(self, node: str | None = None) -> JointSliders:
        """The sliders of a joint_state_publisher_gui that runs here; moving one moves the simulation.

        Args:
            node: Resolved name of its node; the newest one if None.

        Raises:
            SimkitError: None runs, or none of that name.
        """
        from simkit.viz import JointSliders, RvizSettings, RvizView

        gui = self._newest_gui(node)
        for known in self._sliders:
            if known.gui is gui:
                return known
        source = self._scene_source(RvizSettings(fixed_frame=""))
        sliders = JointSliders(
            gui,
            run=while_it_lives(self),
            picture=lambda: RvizView(source.scene()).thumbnail(),
        )
        self._sliders.append(sliders)
        self._views.append(sliders.refresh)
        return sliders

    @property
    def turtlesim(self) -> TurtlesimView:
        """The turtlesim that runs here: `picture()`, `replay()`, `live()`.

        Raises:
            SimkitError: None runs.
        """
        from simkit.nodes.turtlesim import TurtlesimNode
        from simkit.viz import TurtlesimView

        for builtin in reversed(self._builtins):
            if isinstance(builtin.program, TurtlesimNode) and builtin.alive:
                return TurtlesimView(builtin.program, add_view=self._views.append)
        raise SimkitError("no turtlesim runs: sim.rosrun('turtlesim', 'turtlesim_node')")

    def window_of(self, node: ScriptNode | RunningBuiltin) -> RvizView | None:
        """What rviz shows, if this is one; None for other nodes.

        Args:
            node: What `rosrun` answered.
        """
        from simkit.nodes.rviz import RvizProgram
        from simkit.viz import RvizView

        program = getattr(node, "program", None)
        if not isinstance(program, RvizProgram):
            return None
        return RvizView(self._scene_source(program.settings(self.packages)).scene())

    def serve_window_of(self, node: ScriptNode | RunningBuiltin) -> LiveRviz | LiveTurtlesim | None:
        """The window of an rviz or a turtlesim as a page that follows the simulation until the node ends.

        The node prints the address of the page.

        Args:
            node: What `rosrun` answered.
        """
        from simkit.nodes.rviz import RvizProgram
        from simkit.nodes.turtlesim import TurtlesimNode

        program = getattr(node, "program", None)
        if isinstance(program, TurtlesimNode):
            return self._live_turtlesim(program, is_over=lambda: not node.alive)
        if not isinstance(program, RvizProgram):
            return None
        settings = program.settings(self.packages)
        view = self._live_rviz(settings, is_over=lambda: not node.alive)
        program.tell(view.url)
        return view

    def _live_turtlesim(
        self, program: TurtlesimNode, *, is_over: Callable[[], bool]
    ) -> LiveTurtlesim:
        from simkit.viz.turtlesim.page import LiveTurtlesim

        page = LiveTurtlesim(program.frame, is_over=is_over)
        self._views.append(page.refresh)
        self._closers.append(page.close)
        program.tell(page.url)
        return page

    def _live_rviz(
        self, settings: RvizSettings, *, is_over: Callable[[], bool] = lambda: False
    ) -> LiveRviz:
        from simkit.viz import LiveRviz

        view = LiveRviz(self._scene_source(settings, with_room=True), is_over=is_over)
        self._views.append(view.refresh)
        self._closers.append(view.close)
        return view

    def _scene_source(self, settings: RvizSettings, *, with_room: bool = False) -> SceneSource:
        from simkit.viz import RvizEars, SceneSource

        self._ears = self._ears or RvizEars(self._node, self.tf)
        return SceneSource(
            settings,
            ears=self._ears,
            buffer=self.tf,
            parameters=self.graph.params,
            packages=self.packages,
            with_room=with_room,
        )

    def _close_views(self) -> None:
        while self._closers:
            self._closers.pop()()

    def _newest_gui(self, node: str | None) -> JointStatePublisherGui:
        from simkit.nodes.joint_state_publisher import JointStatePublisherGui

        for builtin in reversed(self._builtins):
            program = builtin.program
            if not (isinstance(program, JointStatePublisherGui) and builtin.alive):
                continue
            if node in (None, builtin.name):
                return program
        raise SimkitError(
            f"no joint_state_publisher_gui runs{f' as {node}' if node else ''}: "
            "sim.rosrun('joint_state_publisher_gui', 'joint_state_publisher_gui')"
        )

    def _refresh_views(self) -> None:
        for refresh in self._views:
            refresh()
