"""What `check_urdf` says of a robot that a launch file puts on the parameter server, in short."""

from __future__ import annotations

from collections.abc import Iterator

from simkit.launch.budget import Budget
from simkit.launch.files import Files
from simkit.launch.plan import LaunchPlan
from simkit.packages import PackagePath

PARAMETER = "robot_description"


def robot_lines(plan: LaunchPlan, packages: PackagePath, simulation: object) -> Iterator[str]:
    """One line for each error and warning of a robot, unless they were reported in the simulation already.

    Args:
        plan: The launch file.
        packages: Where meshes are.
        simulation: Whom they are reported to.
    """
    from simkit.urdf import read_robot
    from simkit.urdf.rules.check import brief_lines

    files = Files(packages, Budget())
    for name, value in plan.params.items():
        if name.rpartition("/")[2] != PARAMETER or not isinstance(value, str):
            continue
        source = plan.origins[name].source
        file = name if source is None else files.shown(source)
        reading = read_robot(value, file=file, packages=packages)
        if reading.is_first_report_to(simulation):
            yield from brief_lines(reading, is_file=source is not None)
