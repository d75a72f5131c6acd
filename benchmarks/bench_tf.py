"""TF lookups and insertions against tf2's own Python binding and pytransform3d, in one run.

tf2 is C++; Debian's package python3-tf2-ros brings it for the system's python, which is asked
chain by chain right after our own.
"""

import itertools
import math
import subprocess
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
from figures import Figure, median_of, show
from pytransform3d.transform_manager import NumpyTimeseriesTransform, TemporalTransformManager

from simkit.tf import BufferCore

STEP_NS = 16_000_000
SAMPLES = 200
BETWEEN = 100 * STEP_NS + STEP_NS // 3
"A time between two samples [ns]."
LIMITS = {3: 1.2, 10: 2.0, 50: 4.0}
"Aims: times of tf2, by the length of the chain."
SYSTEM_PYTHON = "/usr/bin/python3"


def chain(frames: int) -> BufferCore:
    """A chain f0 <- f1 <- ... with a history of SAMPLES samples on each link."""
    buffer = BufferCore()
    for sample in range(SAMPLES):
        for link in range(frames):
            insert(buffer, link, sample)
    return buffer


def insert(buffer: BufferCore, link: int, sample: int) -> None:
    """One sample of one link."""
    half = 0.005 * sample + 0.1 * link
    buffer.set_transform(
        f"f{link}",
        f"f{link + 1}",
        translation=(1.0 + 0.01 * sample, 0.5, 0.1),
        rotation=(0.0, 0.0, math.sin(half), math.cos(half)),
        stamp=(sample + 1) * STEP_NS,
        authority="bench",
        static=False,
    )


def peer_chain(frames: int) -> TemporalTransformManager:
    """The same chain for pytransform3d, whose quaternions begin with w."""
    times = np.arange(1, SAMPLES + 1) * STEP_NS * 1e-9
    manager = TemporalTransformManager()
    for link in range(frames):
        half = 0.005 * np.arange(SAMPLES) + 0.1 * link
        pqs = np.zeros((SAMPLES, 7))
        pqs[:, 0] = 1.0 + 0.01 * np.arange(SAMPLES)
        pqs[:, 1], pqs[:, 2] = 0.5, 0.1
        pqs[:, 3], pqs[:, 6] = np.cos(half), np.sin(half)
        manager.add_transform(f"f{link + 1}", f"f{link}", NumpyTimeseriesTransform(times, pqs))
    return manager


def per_call(work: Callable[[], object], calls: int) -> float:
    """Median time of the processor of one call over several rounds [us]; others on the machine do not count."""

    def one_round() -> float:
        start = time.process_time()
        for _ in range(calls):
            work()
        return (time.process_time() - start) / calls * 1e6

    return median_of([one_round() for _ in range(9)])


def peer_lookup(frames: int) -> float | None:
    """The same lookup by tf2's binding [us]; None if the system's python has no tf2."""
    program = [SYSTEM_PYTHON, Path(__file__).with_name("peer_tf2.py"), str(frames)]
    try:
        done = subprocess.run(program, capture_output=True, text=True, check=True)
    except (OSError, subprocess.CalledProcessError):
        return None
    return float(done.stdout)


def show_lookups(frames: int) -> None:
    """The figures of one chain: a time that is asked again and again, another each time, the latest."""
    buffer, last = chain(frames), f"f{frames}"
    moments = itertools.cycle(range(STEP_NS + 1, SAMPLES * STEP_NS, STEP_NS - 1))
    name = f"TF lookup, chain of {frames}"
    again = per_call(lambda: buffer.lookup("f0", last, time=BETWEEN), 500)
    anew = per_call(lambda: buffer.lookup("f0", last, time=next(moments)), 500)
    show(
        Figure(f"{name}, interpolated", again, "us"),
        Figure(f"{name}, interpolated, another time in each call", anew, "us"),
        Figure(f"{name}, latest", per_call(lambda: buffer.lookup("f0", last), 500), "us"),
    )
    peer = peer_lookup(frames)
    if peer is None:
        print("    tf2 is not installed: apt-get install python3-tf2-ros")
        return
    show(
        Figure("    tf2's Python binding (C++)", peer, "us"),
        Figure("    interpolated, over tf2", again / peer, "x", LIMITS.get(frames)),
        Figure("    another time in each call, over tf2", anew / peer, "x", LIMITS.get(frames)),
    )


def show_peer() -> None:
    """pytransform3d's lookup in a chain of ten."""
    buffer, manager = chain(10), peer_chain(10)
    own = per_call(lambda: buffer.lookup("f0", "f10", time=BETWEEN), 500)
    peer = per_call(lambda: manager.get_transform_at_time("f10", "f0", BETWEEN * 1e-9), 20)
    show(
        Figure("pytransform3d, interpolated, chain of 10", peer, "us"),
        Figure("times faster than pytransform3d", peer / own, "x", 50.0, more_is_better=True),
    )


def main() -> None:
    """Print the figures."""
    for frames in (1, 3, 10, 50):
        show_lookups(frames)
    show_peer()
    insertion = BufferCore()
    counter = iter(range(10**9))
    show(Figure("TF insertion", per_call(lambda: insert(insertion, 0, next(counter)), 2000), "us"))


if __name__ == "__main__":
    main()
