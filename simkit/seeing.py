"""What there is to see of a simulation: texts of tf's tools, pictures, plots, replays."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from simkit.errors import SimkitError
from simkit.msgs import Time
from simkit.tf import Buffer, echo_text

if TYPE_CHECKING:
    from simkit.recording import Recording
    from simkit.running import RunningBuiltin
    from simkit.viz import FramesPicture, FramesView, TransformPlot, TurtlesimView


class Seeing:
    """The part of `Simulation` that shows; pictures are made when they are asked for."""

    tf: Buffer
    _builtins: list[RunningBuiltin]
    _views: list[Callable[[], None]]

    @property
    def now(self) -> Time:
        """Virtual time."""
        raise NotImplementedError

    def tf_echo(self, source: str, target: str, *, precision: int = 3) -> str:
        """What `rosrun tf tf_echo source target` prints: where `target` is, seen from `source`."""
        return echo_text(self.tf, source, target, self.now, precision=precision)

    def view_frames(self) -> FramesPicture:
        """The tree of frames as a drawing, with the facts of each edge; `save("frames.pdf")` keeps it."""
        from simkit.viz import FramesPicture

        return FramesPicture(self.tf, now=self.now)

    def rviz(self, fixed_frame: str = "world", *, time: Time | None = None) -> FramesView:
        """The frames in space, to turn and zoom.

        Args:
            fixed_frame: Frame that stands still; the others are drawn in it.
            time: Moment to show; the latest if None.
        """
        from simkit.viz import FramesView

        return FramesView(self.tf, fixed_frame, time=time or Time(0))

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

    def _refresh_views(self) -> None:
        for refresh in self._views:
            refresh()
