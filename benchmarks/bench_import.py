"""What a person waits for before anything happens: imports and commands, each in a fresh process."""

from __future__ import annotations

import subprocess
import sys
import time
from pathlib import Path

from figures import Figure, median_of, show

RUNS = 15
ROBOT = str(Path(__file__).parents[1] / "robots/hello_ros/urdf/hello_ros_robot_3.urdf")
COMMAND = (
    "import sys; from simkit.cli import main; sys.exit(main())"  # what the installed script does
)
COLD: dict[str, tuple[list[str], float | None]] = {
    "python that does nothing": (["-c", "pass"], None),
    "import simkit": (["-c", "import simkit"], 250.0),
    "from simkit import Simulation": (["-c", "from simkit import Simulation"], 250.0),
    "simkit rosmsg show geometry_msgs/Twist": (
        ["-c", COMMAND, "rosmsg", "show", "geometry_msgs/Twist"],
        150.0,
    ),
    "simkit check_urdf hello_ros_robot_3.urdf": (["-c", COMMAND, "check_urdf", ROBOT], 150.0),
}


def run_once(arguments: list[str]) -> float:
    """Wall time of one process [ms]."""
    start = time.perf_counter()
    subprocess.run([sys.executable, *arguments], check=True, capture_output=True)
    return (time.perf_counter() - start) * 1e3


def main() -> None:
    """Print the figures."""
    times: dict[str, list[float]] = {name: [] for name in COLD}
    for _ in range(RUNS):
        for name, (arguments, _target) in COLD.items():
            times[name].append(run_once(arguments))
    for name, (_, target) in COLD.items():
        show(Figure(f"cold: {name}", median_of(times[name]), "ms", target))


if __name__ == "__main__":
    main()
