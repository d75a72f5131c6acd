"""Start of a node from the warm parent until its `init_node` is answered."""

from __future__ import annotations

import subprocess
import sys
import time

from figures import Figure, median_of, percentile_of, show
from play import simulation_with

from simkit import Simulation

STARTS = 25
NODE = """
import rospy
from geometry_msgs.msg import Twist
rospy.init_node("fresh")
rospy.spin()
"""


def start_once(sim: Simulation, number: int) -> float:
    """One start [ms]; the nodes before it keep waiting, as in a class of nodes."""
    start = time.perf_counter()
    node = sim.rosrun("play", "script.py", f"__name:=fresh{number}")
    while node.name not in sim.nodes():
        sim.step()
    return (time.perf_counter() - start) * 1e3


def fresh_interpreter() -> float:
    """A Python that imports numpy, from nothing [ms]."""
    start = time.perf_counter()
    subprocess.run([sys.executable, "-c", "import numpy"], check=True)
    return (time.perf_counter() - start) * 1e3


def main() -> None:
    """Print the figures."""
    with simulation_with(NODE) as sim:
        first = start_once(sim, 0)
        starts, peers = [], []
        for number in range(1, STARTS + 1):
            starts.append(start_once(sim, number))
            peers.append(fresh_interpreter())
    show(
        Figure("node start, warm, median", median_of(starts), "ms", 40.0),
        Figure("node start, warm, 90th percentile", percentile_of(starts, 90), "ms"),
        Figure("the first node, which starts the warm parent", first, "ms"),
        Figure("fresh python that imports numpy, median", median_of(peers), "ms"),
        Figure("node start over fresh python", median_of(starts) / median_of(peers), "x"),
    )


if __name__ == "__main__":
    main()
