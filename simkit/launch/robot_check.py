"""What `check_urdf` says of a robot that a launch file puts on the parameter server, in short."""

from __future__ import annotations

from simkit.launch.budget import Budget
from simkit.launch.files import Files
from simkit.launch.plan import LaunchPlan
from simkit.packages import PackagePath

PARAMETER = "robot_description"


def robot_lines(plan: LaunchPlan, packages: PackagePath) -> dict[str, list[str]]:
    """One line for each error and warning, by the text of the robot.

    Args:
        plan: The launch file.
        packages: Where meshes are.
    """
    from simkit.urdf.rules.brief import brief_lines

    files = Files(packages, Budget())
    found: dict[str, list[str]] = {}
    for name, value in plan.params.items():
        if name.rpartition("/")[2] != PARAMETER or not isinstance(value, str):
            continue
        source = plan.origins[name].source
        file = name if source is None else files.shown(source)
        found[value] = brief_lines(value, file, packages, is_file=source is not None)
    return found
