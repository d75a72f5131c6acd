from __future__ import annotations

from collections.abc import Callable

import pytest

from simkit.nodes.turtlesim import Frame, Reading, Velocity

TICK_NS = 16_000_000
Drive = Callable[..., list[Reading]]


@pytest.fixture
def frame() -> Frame:
    """A window with turtle1 in its centre."""
    frame = Frame()
    frame.spawn()
    return frame


@pytest.fixture
def drive() -> Drive:
    """Updates a frame so many times, with a fresh command for one turtle before each."""
    clock = {"now_ns": 0}

    def drive(
        frame: Frame, ticks: int, velocity: Velocity | None = None, turtle: str = "turtle1"
    ) -> list[Reading]:
        readings = []
        for _ in range(ticks):
            clock["now_ns"] += TICK_NS
            if velocity is not None:
                frame.turtle(turtle).command(velocity)
            by_name = {moved.name: reading for moved, reading in frame.update(clock["now_ns"])}
            readings.append(by_name[turtle])
        return readings

    return drive
