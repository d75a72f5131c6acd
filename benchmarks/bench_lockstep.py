"""One turn of a node process: it is resumed, computes, publishes nothing, and sleeps again."""

from __future__ import annotations

import os
import socket
import time
from collections.abc import Callable

from figures import Figure, median_of, percentile_of, show
from play import simulation_with

TURNS = 5000
FRAME = bytes(17)  # as long as the frame that says `sleep until t`
SLEEPER = """
import rospy
rospy.init_node("sleeper")
rate = rospy.Rate(1000)
while not rospy.is_shutdown():
    rate.sleep()
"""


def turns_of(step: Callable[[], object]) -> list[float]:
    """Duration of each turn [us]."""
    durations = []
    for _ in range(TURNS):
        start = time.perf_counter_ns()
        step()
        durations.append((time.perf_counter_ns() - start) / 1e3)
    return durations


def node_turns() -> list[float]:
    """Turns of a node."""
    with simulation_with(SLEEPER) as sim:
        sim.rosrun("play", "script.py")
        sim.run(0.2)
        return turns_of(sim.step)


def bare_turns() -> list[float]:
    """Turns of a process that only sends back what it gets."""
    ours, theirs = socket.socketpair()
    child = os.fork()
    if child == 0:
        ours.close()
        while data := theirs.recv(64):
            theirs.sendall(data)
        os._exit(0)
    theirs.close()

    def ping() -> None:
        ours.sendall(FRAME)
        ours.recv(64)

    durations = turns_of(ping)
    ours.close()
    os.waitpid(child, 0)
    return durations


def main() -> None:
    """Print the figures."""
    node = node_turns()
    show(
        Figure("lockstep round trip of a node, median", median_of(node), "us", 150.0),
        Figure("lockstep round trip of a node, 90th percentile", percentile_of(node, 90), "us"),
    )
    if hasattr(os, "fork"):
        bare = median_of(bare_turns())
        show(
            Figure("bare socketpair ping-pong, median", bare, "us"),
            Figure("lockstep over bare ping-pong", median_of(node) / bare, "x"),
        )


if __name__ == "__main__":
    main()
