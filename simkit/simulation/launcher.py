"""How a simulation starts launch files."""

from __future__ import annotations

import weakref
from pathlib import Path
from typing import TYPE_CHECKING

from simkit.errors import UnknownNameError
from simkit.graph.names import free_name
from simkit.nodes import builtin_nodes
from simkit.packages import PackagePath
from simkit.simulation.gazebo_starter import GZSERVER

if TYPE_CHECKING:
    from simkit.graph.process import Permissions
    from simkit.launch import Launch, LaunchPlan
    from simkit.simulation.simulation import Simulation


class Launcher:
    """The part of a `Simulation` that launches; launch files are read when they are asked for.

    Args:
        sim: The simulation.
    """

    def __init__(self, sim: Simulation) -> None:
        self._sim: Simulation = weakref.proxy(sim)
        self._launches: list[Launch] = []

    def launch_plan(
        self, package_or_path: str | Path, file: str | None = None, *arguments: str
    ) -> LaunchPlan:
        """What a launch file comes to: its parameters and nodes. Nothing is set or started.

        Args:
            package_or_path: Package that has the file, the path of the file, or its text (what has a `<` in it).
            file: Name of the launch file in the package; None with a path or a text.
            *arguments: `name:=value` for its arguments.

        Raises:
            LaunchError: There is no such file, or roslaunch would refuse it.
        """
        from simkit.launch import evaluate, find_launch_file, given_arguments

        words = [str(package_or_path), *([] if file is None else [file]), *arguments]
        source: Path | str = words[0]
        rest = words[1:]
        if "<" not in words[0]:
            source, rest = find_launch_file(words, self._sim.packages)
        given = given_arguments(rest)
        old = [one for one in self._launches if one.is_of(str(source), given)]
        nodes = set(self._sim.graph.nodes).difference(*(one.nodes for one in old))
        taken = {name.rpartition("/")[2] for name in nodes}

        def anonymous(identity: str) -> str:
            taken.add(name := free_name(identity, taken))
            return name

        return evaluate(source, packages=self._sim.packages, arguments=given, anonymous=anonymous)

    def roslaunch(
        self,
        package_or_path: str | Path | LaunchPlan,
        file: str | None = None,
        *arguments: str,
        permissions: Permissions | None = None,
        all_on_screen: bool = False,
    ) -> Launch:
        """Launch a file: set its parameters and start its nodes, in its order.

        A launch of the same file with the same arguments that still runs is ended first.

        Args:
            package_or_path: Package that has the file, the path or text of the file, or what `launch_plan` gave.
            file: Name of the launch file in the package; None otherwise.
            *arguments: `name:=value` for its arguments.
            permissions: What the file and its nodes may do; anything if None.
            all_on_screen: Whether to show what its nodes print, whatever `output=` says.

        Returns:
            A handle with `nodes` by name, `alive`, `summary`, `failures`, `shutdown()`.

        Raises:
            LaunchError: There is no such file, or roslaunch would refuse it.
        """
        from simkit.launch import Launch, LaunchPlan

        self._sim.require_open()
        if isinstance(package_or_path, LaunchPlan):
            plan = package_or_path
        else:
            plan = self.launch_plan(package_or_path, file, *arguments)
        launch = Launch(
            plan,
            self._sim.graph,
            self._sim.start_node,
            folders=[str(folder) for folder in self._sim.packages.folders],
            permissions=permissions,
            all_on_screen=all_on_screen,
        )
        if any((node.package, node.type) == GZSERVER for node in plan.nodes):
            self._sim.gazebo_starter.begin()
        self._end_older(plan, launch)
        self._check_robots(plan, launch)
        launch.start()
        self._launches.append(launch)
        return launch

    def _end_older(self, plan: LaunchPlan, launch: Launch) -> None:
        for older in self._launches:
            if older.is_of(plan.file, plan.given) and older.alive:
                launch.say(f"{plan.shown_file} runs already: its nodes end, and start anew")
                older.shutdown()
        self._launches[:] = [one for one in self._launches if one.alive]

    def _check_robots(self, plan: LaunchPlan, launch: Launch) -> None:
        from simkit.launch import robot_lines

        for line in robot_lines(plan, self._sim.packages, self._sim.graph):
            launch.say(line)


def find_script(packages: PackagePath, package: str, executable: str) -> tuple[Path, str]:
    """The script that `rosrun` means, and how to show its path.

    Args:
        packages: Where packages are.
        package: Package name.
        executable: File name of the script.

    Raises:
        UnknownNameError: No such package, or no such executable in it; names near ones.
    """
    builtin_packages = {name for name, _ in builtin_nodes()}
    try:
        found = packages.find(package)
    except UnknownNameError as error:
        known = sorted({*error.known, *builtin_packages})
        if package in builtin_packages:
            programs = [program for name, program in builtin_nodes() if name == package]
            raise UnknownNameError(f"program in {package!r}", executable, programs) from None
        raise UnknownNameError("package", package, known) from None
    path = found.find_executable(executable)
    return path, path.relative_to(found.folder.parent).as_posix()
