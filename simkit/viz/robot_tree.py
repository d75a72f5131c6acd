"""The tree of a robot as a picture: a box for each link, on the line to its parent the joint."""

from __future__ import annotations

from pathlib import Path

from simkit.saving import save_as
from simkit.urdf.model import Robot
from simkit.viz.draw.drawing import Drawing
from simkit.viz.draw.svg import svg_text
from simkit.viz.robot_dot import robot_dot_text
from simkit.viz.robot_sheet import draw_robot_tree


class RobotTree:
    """What `urdf_to_graphviz` draws of a URDF: links, joints, and where each joint is.

    Args:
        robot: The robot.

    Source:
        urdf_to_graphviz of urdfdom has the names and origins; type, axis and limits are ours, and so is the layout.
    """

    def __init__(self, robot: Robot) -> None:
        self._robot = robot

    def to_svg(self) -> str:
        """The tree as an SVG document; equal robots give equal text."""
        return svg_text(self._drawing())

    def to_png(self, *, scale: float = 2.0) -> bytes:
        """The tree as a PNG file.

        Args:
            scale: Pixels of the file per pixel of the SVG.
        """
        from simkit.viz.draw.figure import png_bytes

        return png_bytes(self._drawing(), scale=scale)

    def to_pdf(self) -> bytes:
        """The tree as a PDF file of one page."""
        from simkit.viz.draw.figure import pdf_bytes

        return pdf_bytes(self._drawing())

    def to_dot(self) -> str:
        """The tree in graphviz' language, as urdf_to_graphviz writes it."""
        return robot_dot_text(self._robot)

    def save(self, path: str | Path) -> None:
        """Write a file: `.svg`, `.pdf`, `.png` or `.gv` by its suffix.

        Raises:
            UnknownNameError: The suffix is another one.
        """
        save_as(
            path,
            {".gv": self.to_dot, ".pdf": self.to_pdf, ".png": self.to_png, ".svg": self.to_svg},
        )

    def __repr__(self) -> str:
        robot = self._robot
        return f"RobotTree({robot.name}: {len(robot.links)} links, {len(robot.joints)} joints)"

    def _repr_svg_(self) -> str:
        return self.to_svg()

    def _drawing(self) -> Drawing:
        return draw_robot_tree(self._robot)
