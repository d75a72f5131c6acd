"""How well one turtle follows: how far away, and at which angle, it has a place before it."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, Protocol

from simkit import Simulation


class Planar(Protocol):
    """A pose in the plane, of turtlesim or of a recording."""

    x: float
    y: float
    theta: float


def gap(pose: Planar, place: Planar) -> float:
    """Distance between two turtles [m]."""
    return math.dist((pose.x, pose.y), (place.x, place.y))


def bearing(pose: Planar, place: Planar) -> float:
    """Angle by which a turtle must turn left to look at a place, from -pi to pi [rad]."""
    direction = math.atan2(place.y - pose.y, place.x - pose.x)
    return math.remainder(direction - pose.theta, math.tau)


def seen_from(pose: Planar, place: Planar) -> tuple[float, float]:
    """Where a turtle sees a place: ahead of it, and to its left [m]."""
    distance, angle = gap(pose, place), bearing(pose, place)
    return distance * math.cos(angle), distance * math.sin(angle)


def ahead_of(pose: Planar, distance: float) -> tuple[float, float]:
    """The place at a distance [m] ahead of a turtle, in the world [m]."""
    return (
        pose.x + distance * math.cos(pose.theta),
        pose.y + distance * math.sin(pose.theta),
    )


def drive(
    sim: Simulation, *, speed: float, turn_rate: float, turtle: str = "turtle1"
) -> Callable[[], None]:
    """Let a turtle drive from now on, on a circle or straight ahead.

    Args:
        sim: The simulation.
        speed: Speed [m/s].
        turn_rate: Turn rate, to the left [rad/s].
        turtle: Name of the turtle.

    Returns:
        Call it to let go of the turtle, which stops a second later.
    """
    command = {"linear": {"x": speed}, "angular": {"z": turn_rate}}
    topic = f"/{turtle}/cmd_vel"
    driver = sim.rostopic_pub(topic, "geometry_msgs/Twist", command, rate=10)
    return driver.shutdown


def two_turtles(sim: Simulation) -> tuple[Any, Any]:
    """The newest poses of turtle1 and turtle2."""
    return sim.latest("/turtle1/pose"), sim.latest("/turtle2/pose")


def samples(sim: Simulation, seconds: float, *, step: float = 0.1) -> list[tuple[Any, Any]]:
    """Let time pass, and look at turtle1 and turtle2 again and again.

    Args:
        sim: A simulation with both turtles.
        seconds: How long [s].
        step: Time between two looks [s].
    """
    seen = []
    for _ in range(round(seconds / step)):
        sim.run(step)
        seen.append(two_turtles(sim))
    return seen


def come_near(sim: Simulation, distance: float, *, timeout: float) -> float:
    """Let time pass until turtle2 is near turtle1.

    Args:
        sim: A simulation with both turtles.
        distance: What is near [m].
        timeout: Give up after so long [s].

    Returns:
        The smallest distance that was seen [m].
    """
    nearest = gap(*two_turtles(sim))
    end = sim.now.to_sec() + timeout
    while nearest >= distance and sim.now.to_sec() < end:
        sim.run(0.1)
        nearest = min(nearest, gap(*two_turtles(sim)))
    return nearest


def usual_bearing(seen: list[tuple[Any, Any]]) -> float:
    """The angle at which turtle2 had turtle1 beside its nose for nine tenths of the time [rad].

    Args:
        seen: Poses of turtle1 and turtle2.
    """
    angles = sorted(abs(bearing(two, one)) for one, two in seen)
    return angles[len(angles) * 9 // 10]


def come_to_rest(sim: Simulation, *, timeout: float) -> None:
    """Let time pass until turtle2 hardly moves any more, at most `timeout` [s]."""
    sim.run_until(lambda: bool(sim.latest("/turtle2/pose").linear_velocity < 0.04), timeout)


def reaction_time(
    sim: Simulation, place: tuple[float, float, float], *, timeout: float
) -> float | None:
    """Let turtle1 jump, and measure after how long turtle2, now at rest, sets out or turns [s].

    Args:
        sim: A simulation with both turtles.
        place: Where turtle1 jumps to: x [m], y [m], theta [rad].
        timeout: Give up after so long [s].

    Returns:
        The time, or None if turtle2 stays.
    """
    rest = sim.latest("/turtle2/pose")
    begin = sim.now.to_sec()
    sim.call("/turtle1/teleport_absolute", *place)

    def is_on_its_way() -> bool:
        pose = sim.latest("/turtle2/pose")
        return (
            gap(pose, rest) > 0.15 or abs(math.remainder(pose.theta - rest.theta, math.tau)) > 0.2
        )

    return sim.now.to_sec() - begin if sim.run_until(is_on_its_way, timeout) else None
