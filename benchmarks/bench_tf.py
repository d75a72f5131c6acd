"""TF lookups and insertions against pytransform3d's transform manager, in one run."""

import math
import time
from collections.abc import Callable

import numpy as np
from figures import Figure, median_of, show
from pytransform3d.transform_manager import NumpyTimeseriesTransform, TemporalTransformManager

from simkit.tf import BufferCore

STEP_NS = 16_000_000
SAMPLES = 200


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


def main() -> None:
    """Print the figures."""
    between = 100 * STEP_NS + STEP_NS // 3
    targets = {3: 15.0, 10: 30.0}
    for frames in (1, 3, 10, 50):
        buffer = chain(frames)
        last = f"f{frames}"
        at_time = per_call(lambda b=buffer, f=last: b.lookup("f0", f, time=between), 500)
        latest = per_call(lambda b=buffer, f=last: b.lookup("f0", f), 500)
        show(
            Figure(
                f"TF lookup, chain of {frames}, interpolated", at_time, "us", targets.get(frames)
            )
        )
        show(Figure(f"TF lookup, chain of {frames}, latest", latest, "us"))
        if frames == 10:
            manager = peer_chain(frames)
            peer = per_call(
                lambda m=manager: m.get_transform_at_time("f10", "f0", between * 1e-9), 20
            )
            show(Figure("pytransform3d, the same lookup, chain of 10", peer, "us"))
            show(
                Figure(
                    "times faster than pytransform3d",
                    peer / at_time,
                    "x",
                    50.0,
                    more_is_better=True,
                )
            )
    insertion = BufferCore()
    counter = iter(range(10**9))
    show(Figure("TF insertion", per_call(lambda: insert(insertion, 0, next(counter)), 2000), "us"))


if __name__ == "__main__":
    main()
