"""tf2's BufferCore: the tree of frames over the last seconds, in integers and tuples."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from simkit.geometry import Quaternion, Transform, Vector, canonical
from simkit.tf import frame_report
from simkit.tf.admission import is_admissible, objections, without_slash
from simkit.tf.cache import LATEST
from simkit.tf.errors import InvalidArgumentException, LookupException, TransformException
from simkit.tf.frame_tree import NO_FRAME, FrameTable, as_lines, latest_common_time
from simkit.tf.path import StampedTransform, frames_between, transform_between

DEFAULT_CACHE_TIME: Final = 10_000_000_000
"How long a buffer remembers [ns]."


class BufferCore:
    """Stores stamped transforms between frames, and answers what lies between any two.

    One rule: `lookup(a, b)` is T_ab, which takes coordinates in b (source) to coordinates in a
    (target); it is also the pose of b seen from a. Times are integer nanoseconds, 0 (`LATEST`)
    means the latest common time. Nothing here depends on a clock, on messages or on numpy.

    Args:
        cache_time_ns: How long a moving frame is remembered [ns].
        on_warning: Is given tf's sentence for each transform or name that is refused.

    Source:
        tf2 `BufferCore`, Noetic. Stamps are exact to 1 ns, as in C++.
    """

    def __init__(
        self,
        cache_time_ns: int = DEFAULT_CACHE_TIME,
        on_warning: Callable[[str], None] | None = None,
    ) -> None:
        self.cache_time = cache_time_ns
        self.on_warning = on_warning
        self.frames = FrameTable(cache_time_ns)

    def set_transform(
        self,
        parent: str,
        child: str,
        *,
        translation: Vector,
        rotation: Quaternion,
        stamp: int = 0,
        authority: str = "default_authority",
        static: bool = False,
    ) -> bool:
        """Store T_pc for p = `parent` and c = `child`, unless something is wrong with it.

        Args:
            parent: Frame that the transform is expressed in; one leading slash is dropped.
            child: Frame that is placed; one leading slash is dropped.
            translation: Origin of `child` in `parent` [m].
            rotation: Orientation of `child` in `parent`, xyzw; stored as it is.
            stamp: Time it holds for [ns].
            authority: Node that broadcast it.
            static: Whether it holds at every time; the first transform of a frame decides.

        Returns:
            Whether it was stored; if not, `on_warning` was given the reason.
        """
        parent, child = without_slash(parent), without_slash(child)
        faults: list[str] = []
        if not is_admissible(parent, child, translation=translation, rotation=rotation):
            faults += objections(
                parent, child, translation=translation, rotation=rotation, authority=authority
            )
        if not faults:
            refusal = self.frames.insert(
                child,
                parent,
                stamp=stamp,
                translation=translation,
                rotation=rotation,
                static=static,
            )
            if not refusal:
                self.frames.authorities[self.frames.number(child)] = authority
                return True
            faults = [
                f"{refusal} for frame {child} (parent {parent}) at time {stamp / 1e9:f} "
                f"according to authority {authority}"
            ]
        for fault in faults:
            self._warn(fault)
        return False

    def lookup(self, target: str, source: str, *, time: int = LATEST) -> StampedTransform:
        """T_ab for a = `target` and b = `source`.

        A frame seen from itself is the identity, also if its name is unknown.

        Raises:
            InvalidArgumentException: A name is empty or starts with a slash.
            LookupException: A name is unknown, or the tree has a loop.
            ConnectivityException: Both exist, in two trees.
            ExtrapolationException: A frame on the way lacks data at `time`.
        """
        if target == source:
            return StampedTransform(Transform(), time or self._newest_stamp(target))
        return transform_between(
            self.frames,
            self._number(target, "lookupTransform argument target_frame"),
            self._number(source, "lookupTransform argument source_frame"),
            time=time,
        )

    def lookup_full(
        self, target: str, source: str, *, target_time: int, source_time: int, fixed: str
    ) -> StampedTransform:
        """Where `source` was at `source_time`, seen from where `target` was at `target_time`.

        Args:
            target: Frame of the result (a).
            source: Frame of the data (b).
            target_time: Time of the target [ns].
            source_time: Time of the source [ns].
            fixed: Frame that is taken not to have moved in between.

        Returns:
            T_ab, its quaternion with unit length; the stamp is that of the target.

        Raises:
            TransformException: As `lookup`; the source's side is looked up first.
        """
        for role, name in (("target", target), ("source", source), ("fixed", fixed)):
            self._number(name, f"lookupTransform argument {role}_frame")
        from_source = self.lookup(fixed, source, time=source_time)
        to_target = self.lookup(target, fixed, time=target_time)
        product = _canonical(to_target.transform) @ _canonical(from_source.transform)
        return StampedTransform(_canonical(product), to_target.stamp)

    def can_transform(self, target: str, source: str, *, time: int = LATEST) -> tuple[bool, str]:
        """Whether `lookup` would answer, and if not, why (empty for an invalid name)."""
        if target == source:
            return True, ""
        names = {"target_frame": target, "source_frame": source}
        if not self._are_names(names):
            return False, ""
        unknown = self._unknown(names)
        return (False, unknown) if unknown else self._joined(target, source, time)

    def can_transform_full(
        self, target: str, source: str, *, target_time: int, source_time: int, fixed: str
    ) -> tuple[bool, str]:
        """Whether `lookup_full` would answer, and if not, why; the target's side comes first."""
        names = {"target_frame": target, "source_frame": source, "fixed_frame": fixed}
        if not self._are_names(names):
            return False, ""
        unknown = self._unknown(names)
        if unknown:
            return False, unknown
        answer = self._joined(target, fixed, target_time)
        return self._joined(fixed, source, source_time) if answer[0] else answer

    def latest_common_time(self, target: str, source: str) -> int:
        """Newest time at which the whole way between two frames has data [ns]; 0 if static.

        Raises:
            InvalidArgumentException: A name is empty or starts with a slash.
            LookupException: A name is unknown, or the tree has a loop.
            TransformException: No way joins the frames.
        """
        numbers = [self._number(name, "get_latest_common_time") for name in (target, source)]
        return latest_common_time(self.frames, *numbers)

    def chain(
        self, target: str, source: str, *, target_time: int, source_time: int, fixed: str
    ) -> list[str]:
        """Frames on the way from `source` over `fixed` to `target`, each once.

        Raises:
            TransformException: As `lookup`.
        """
        a, b, c = (self._number(name, "chain") for name in (target, source, fixed))
        way = frames_between(self.frames, c, b, time=source_time)
        onward = frames_between(self.frames, a, c, time=target_time)
        if way and onward and way[-1] == onward[0]:
            way.pop()
        return [self.frames.names[number] for number in way + onward]

    def parent_of(self, frame: str, *, time: int = LATEST) -> str | None:
        """Parent of a frame at `time` [ns]; None for a root, an unknown frame or missing data."""
        cache = self.frames.caches[self.frames.number(frame)]
        edge = cache.at(time) if cache is not None else None
        return self.frames.names[edge[0]] if edge and edge[0] else None

    def frame_exists(self, frame: str) -> bool:
        """Whether a transform ever named this frame."""
        return frame in self.frames

    @property
    def frame_strings(self) -> list[str]:
        """All frames in the order of their appearance, a child before its parent."""
        return self.frames.known_names

    def all_frames_as_string(self) -> str:
        """One line per frame that ever had a parent."""
        return as_lines(self.frames)

    def all_frames_as_yaml(self, now: float = 0.0) -> str:
        """Parent, broadcaster, rate and stamps of each frame; ages if `now` [s] is given."""
        return frame_report.as_yaml(self.frames, now)

    def all_frames_as_dot(self, now: float = 0.0) -> str:
        """The tree for graphviz; ages if `now` [s] is given."""
        return frame_report.as_dot(self.frames, now)

    def clear(self) -> None:
        """Forget the transforms of moving frames; names and static transforms stay."""
        self.frames.clear()

    def _warn(self, text: str) -> None:
        if self.on_warning is not None:
            self.on_warning(text)

    def _newest_stamp(self, frame: str) -> int:
        cache = self.frames.caches[self.frames.number(frame)]
        return cache.newest_link[0] if cache else 0

    def _number(self, name: str, role: str) -> int:
        number = self.frames.number(name)
        if number != NO_FRAME and not name.startswith("/"):
            return number
        fault = _name_fault(name, role)
        if fault:
            raise InvalidArgumentException(fault, frame=name)
        raise LookupException(f'"{name}" passed to {role} does not exist. ', frame=name)

    def _are_names(self, names: dict[str, str]) -> bool:
        """Whether all can be names of frames; `on_warning` is given the first that cannot."""
        for role, name in names.items():
            fault = _name_fault(name, f"canTransform argument {role}")
            if fault:
                self._warn(fault)
                return False
        return True

    def _unknown(self, names: dict[str, str]) -> str:
        """The sentence of tf for the names that no transform ever used; empty if there are none."""
        return " ".join(
            # The form for the fixed frame differs, and lacks a space, in tf2 itself.
            f"fixed_frame: {name}does not exist."
            if role == "fixed_frame"
            else f"canTransform: {role} {name} does not exist."
            for role, name in names.items()
            if self.frames.number(name) == NO_FRAME
        )

    def _joined(self, target: str, source: str, time: int) -> tuple[bool, str]:
        number = self.frames.number
        try:
            transform_between(self.frames, number(target), number(source), time=time)
        except TransformException as error:
            return False, str(error)
        return True, ""


def _canonical(transform: Transform) -> Transform:
    return Transform(transform.translation, canonical(transform.rotation))


def _name_fault(name: str, role: str) -> str:
    """Why a text cannot be the name of a frame, in tf's words; empty if it can."""
    if not name:
        return f"Invalid argument passed to {role} in tf2 frame_ids cannot be empty"
    if name.startswith("/"):
        return (
            f'Invalid argument "{name}" passed to {role} '
            "in tf2 frame_ids cannot start with a '/' like: "
        )
    return ""
