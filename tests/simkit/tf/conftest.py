"""A buffer that is easy to fill, and an oracle that shares no code with it."""

from __future__ import annotations

import importlib
import itertools
import math
import sys
from collections.abc import Iterator, Sequence
from types import ModuleType, SimpleNamespace
from typing import Any

import numpy as np
import pytest

from simkit.graph.process import client
from simkit.msgs import Duration, Time, message_class
from simkit.tf.buffer_core import BufferCore
from simkit.tf.path import StampedTransform

SECOND = 10**9
Xyz = Sequence[float]


class Tree:
    """A buffer core in seconds, with what it was warned of."""

    def __init__(self, cache_time: float = 10.0) -> None:
        self.warnings: list[str] = []
        self.core = BufferCore(round(cache_time * SECOND), self.warnings.append)

    def put(
        self,
        parent: str,
        child: str,
        t: float = 0.0,
        xyz: Xyz = (0.0, 0.0, 0.0),
        q: Xyz = (0.0, 0.0, 0.0, 1.0),
        *,
        static: bool = False,
        authority: str = "me",
    ) -> bool:
        """Child `child` in parent `parent` at `t` seconds."""
        x, y, z = xyz
        qx, qy, qz, qw = q
        return self.core.set_transform(
            parent,
            child,
            translation=(x, y, z),
            rotation=(qx, qy, qz, qw),
            stamp=round(t * SECOND),
            authority=authority,
            static=static,
        )

    def chain_of(self, *frames: str, step: Xyz, t: float = 0.0) -> None:
        """Each frame is `step` away from the one before it."""
        for parent, child in itertools.pairwise(frames):
            self.put(parent, child, t, step)

    def lookup(self, target: str, source: str, t: float = 0.0) -> StampedTransform:
        return self.core.lookup(target, source, time=round(t * SECOND))

    def can(self, target: str, source: str, t: float = 0.0) -> bool:
        return self.core.can_transform(target, source, time=round(t * SECOND))[0]

    def full(
        self, target: str, t_target: float, source: str, t_source: float, fixed: str
    ) -> StampedTransform:
        return self.core.lookup_full(
            target,
            source,
            target_time=round(t_target * SECOND),
            source_time=round(t_source * SECOND),
            fixed=fixed,
        )

    def can_full(
        self, target: str, t_target: float, source: str, t_source: float, fixed: str
    ) -> bool:
        return self.core.can_transform_full(
            target,
            source,
            target_time=round(t_target * SECOND),
            source_time=round(t_source * SECOND),
            fixed=fixed,
        )[0]


def _matrix(xyz: Xyz, q: Xyz) -> Any:
    """4x4 matrix, by turning the unit vectors with Rodrigues' formula."""
    x, y, z, w = np.asarray(q, dtype=float) / np.linalg.norm(q)
    sine = math.sqrt(x * x + y * y + z * z)
    axis = np.array([x, y, z]) / sine if sine > 0 else np.array([1.0, 0.0, 0.0])
    angle = 2.0 * math.atan2(sine, w)
    cross = np.array(
        [[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]], dtype=float
    )
    matrix = np.identity(4)
    matrix[:3, :3] = (
        np.identity(3) + math.sin(angle) * cross + (1.0 - math.cos(angle)) * cross @ cross
    )
    matrix[:3, 3] = xyz
    return matrix


def _between(start: Any, end: Any, ratio: float) -> Any:
    """The matrix on the way: the relative turn is cut to its share, the origin goes straight."""
    relative = start[:3, :3].T @ end[:3, :3]
    angle = math.acos(min(1.0, max(-1.0, (np.trace(relative) - 1.0) / 2.0)))
    matrix = np.identity(4)
    matrix[:3, :3] = start[:3, :3]
    if angle > 1e-9:
        skew = (relative - relative.T) / (2.0 * math.sin(angle))
        part = angle * ratio
        turn = np.identity(3) + math.sin(part) * skew + (1.0 - math.cos(part)) * skew @ skew
        matrix[:3, :3] = start[:3, :3] @ turn
    matrix[:3, 3] = (1.0 - ratio) * start[:3, 3] + ratio * end[:3, 3]
    return matrix


class Oracle:
    """Knows where everything is, by brute force: samples in a list, matrices to the root."""

    def __init__(self) -> None:
        self.samples: dict[str, list[tuple[float, str, Any]]] = {}

    def put(self, parent: str, child: str, t: float, xyz: Xyz, q: Xyz) -> None:
        self.samples.setdefault(child, []).append((t, parent, _matrix(xyz, q)))
        self.samples[child].sort(key=lambda sample: sample[0])

    def in_parent(self, frame: str, t: float) -> tuple[str, Any] | None:
        samples = self.samples[frame]
        before = [sample for sample in samples if sample[0] <= t]
        after = [sample for sample in samples if sample[0] >= t]
        if not before or not after:
            return None
        (t0, parent, start), (t1, other, end) = before[-1], after[0]
        if t0 == t1 or parent != other:
            return parent, start
        return parent, _between(start, end, (t - t0) / (t1 - t0))

    def in_root(self, frame: str, t: float) -> Any:
        matrix = np.identity(4)
        while frame in self.samples:
            step = self.in_parent(frame, t)
            assert step is not None, f"{frame} has no data at {t}"
            frame, link = step
            matrix = link @ matrix
        return matrix

    def lookup(self, target: str, source: str, t: float) -> Any:
        return np.linalg.inv(self.in_root(target, t)) @ self.in_root(source, t)

    def newest_way(self, frame: str) -> list[str]:
        """The frame and its newest ancestors."""
        way = [frame]
        while way[-1] in self.samples:
            way.append(self.samples[way[-1]][-1][1])
        return way

    def common_time(self, target: str, source: str, static: set[str]) -> float | None:
        """Least newest stamp on the way; 0 if all is static, None without a way."""
        up, down = self.newest_way(source), self.newest_way(target)
        shared = [frame for frame in up if frame in down]
        if not shared:
            return None
        links = up[: up.index(shared[0])] + down[: down.index(shared[0])]
        stamps = [self.samples[frame][-1][0] for frame in links if frame not in static]
        return min((stamp for stamp in stamps if stamp), default=0.0)


@pytest.fixture
def tree() -> Tree:
    return Tree()


@pytest.fixture(scope="session")
def tools() -> SimpleNamespace:
    """Classes and functions that tests need by name."""
    return SimpleNamespace(Tree=Tree, Oracle=Oracle, matrix=_matrix, between=_between)


@pytest.fixture
def yaw() -> Any:
    """Quaternion of a turn about z."""
    return lambda angle: (0.0, 0.0, math.sin(angle / 2.0), math.cos(angle / 2.0))


@pytest.fixture
def stamped() -> Any:
    """Makes a geometry_msgs/TransformStamped."""

    def make(
        parent: str,
        child: str,
        t: float = 0.0,
        xyz: Xyz = (0.0, 0.0, 0.0),
        q: Xyz = (0.0, 0.0, 0.0, 1.0),
    ) -> Any:
        message: Any = message_class("geometry_msgs/TransformStamped")()
        message.header.frame_id = parent
        message.header.stamp = Time.from_nsec(round(t * SECOND))
        message.child_frame_id = child
        position, rotation = message.transform.translation, message.transform.rotation
        position.x, position.y, position.z = xyz
        rotation.x, rotation.y, rotation.z, rotation.w = q
        return message

    return make


class FakeRospy(ModuleType):
    """As much of rospy as tf touches, with a clock that moves when somebody sleeps."""

    def __init__(self) -> None:
        super().__init__("rospy")
        self.Duration = Duration
        self.now_ns = 100 * SECOND
        self.Time = type("Time", (Time,), {"__slots__": (), "now": lambda: self.get_rostime()})
        self.warnings: list[str] = []
        self.published: list[tuple[str, Any]] = []
        self.callbacks: dict[str, Any] = {}
        self.agenda: list[tuple[int, Any]] = []
        self.logwarn = self.warnings.append
        self.Subscriber = self._subscribe
        self.storing: Any = ModuleType("rospy.storing")
        self.storing.StoringSubscriber, self.storing.now_ns = self._subscribe, lambda: self.now_ns
        self.Publisher = self._advertise

    def get_rostime(self) -> Any:
        return self.Time.from_nsec(self.now_ns)

    def sleep(self, duration: Any) -> None:
        self.now_ns += duration.to_nsec()
        while self.agenda and self.agenda[0][0] <= self.now_ns:
            self.agenda.pop(0)[1]()

    def at(self, seconds: float, action: Any) -> None:
        """Do something when the clock reaches a time."""
        self.agenda.append((round(seconds * SECOND), action))

    def _subscribe(
        self, topic: str, message_class: Any, callback: Any, queue_size: int | None = None
    ) -> object:
        self.callbacks[topic] = callback
        return object()

    def _advertise(self, topic: str, message_class: Any, queue_size: int) -> Any:
        return SimpleNamespace(publish=lambda message: self.published.append((topic, message)))


def _forget_tf() -> None:
    for name in [name for name in sys.modules if name.startswith("simkit.ros1.tf")]:
        del sys.modules[name]


@pytest.fixture
def rospy(monkeypatch: pytest.MonkeyPatch) -> Iterator[FakeRospy]:
    """Stands for rospy, which lives in node processes only."""
    fake = FakeRospy()
    monkeypatch.setitem(sys.modules, "rospy", fake)
    monkeypatch.setitem(sys.modules, "rospy.storing", fake.storing)
    _forget_tf()
    yield fake
    _forget_tf()


@pytest.fixture
def tf(rospy: FakeRospy, monkeypatch: pytest.MonkeyPatch) -> Any:
    """The module that a script gets by `import tf`."""
    with client.preloading():
        for name in ("tf2_py", "tf2_py.buffer_core", "tf2_ros", "tf"):
            module = importlib.import_module(f"simkit.ros1.{name}")
            if name != "tf":
                monkeypatch.setitem(sys.modules, name, module)
    module.passed = []  # type: ignore[attr-defined]
    for name in ("tf2_py.buffer_core", "tf.transformer"):
        asking = importlib.import_module(f"simkit.ros1.{name}")
        monkeypatch.setattr(asking, "let_time_pass", lambda: module.passed.append(rospy.now_ns))
    return module
