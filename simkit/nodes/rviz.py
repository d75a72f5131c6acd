"""rviz as a node: what its command line asks to be shown; the simulation makes the view of it.

Source: RViz 1.14 for the options.
"""

from __future__ import annotations

import argparse
from dataclasses import replace
from typing import TYPE_CHECKING, Final

from simkit.commands.errors import UsageError
from simkit.errors import SimkitError
from simkit.graph import Node
from simkit.nodes.program import Program
from simkit.packages import PackagePath

if TYPE_CHECKING:
    from simkit.viz.stage.rviz_settings import RvizSettings

USAGE: Final = "usage: rviz [-d FILE.rviz] [-f FIXED_FRAME]"


class RvizProgram(Program):
    """The program `rviz` of the package rviz.

    Args:
        node: Its place in the graph.
        argv: `-d` and a configuration, `-f` and the fixed frame.

    Raises:
        UsageError: An argument is none of these.
    """

    window = "RViz"

    def __init__(self, node: Node, argv: list[str]) -> None:
        super().__init__(node)
        arguments = _arguments(argv)
        self._file: str | None = arguments.display_config
        self._fixed_frame: str = arguments.fixed_frame or ""

    def settings(self, packages: PackagePath) -> RvizSettings:
        """What is to be seen.

        As in RViz, a configuration that cannot be read is complained of, and the view is there without it.

        Args:
            packages: Says whether the configuration may be read: it may be that of somebody's launch file.
        """
        from simkit.viz.stage.rviz_settings import RvizSettings

        try:
            found = self._configured(packages)
        except SimkitError as error:
            found = RvizSettings(fixed_frame="", complaint=f"{error}.")
        return replace(found, fixed_frame=self._fixed_frame or found.fixed_frame)

    def _configured(self, packages: PackagePath) -> RvizSettings:
        from simkit.viz.stage.rviz_config import read_config
        from simkit.viz.stage.rviz_settings import RvizSettings

        if self._file is None:
            return RvizSettings(fixed_frame="")
        if not packages.may_read(self._file):
            raise SimkitError(f"{self._file} is in no package, and only those may be read here")
        return read_config(self._file)


def _arguments(argv: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(add_help=False, allow_abbrev=False, exit_on_error=False)
    parser.add_argument("-d", "--display-config")
    parser.add_argument("-f", "--fixed-frame")
    try:
        found, unknown = parser.parse_known_args(argv)
    except argparse.ArgumentError as error:
        raise UsageError(f"rviz: {error}; {USAGE}") from None
    if unknown:
        raise UsageError(f"rviz: {unknown[0]!r} is no argument of it; {USAGE}")
    return found
