"""ROS time: whole seconds and nanoseconds.

Source:
    genpy's `rostime` (Noetic): canonical form, errors, comparison and arithmetic. Also from
    there: the result of an operation is a plain `Time` or `Duration`, whatever the subclass.
"""

from __future__ import annotations

from numbers import Integral, Real
from typing import ClassVar, Self, TypeGuard, overload

NSEC_PER_SEC = 1_000_000_000


def _is_integer(value: object) -> TypeGuard[int]:
    return isinstance(value, Integral)


def _is_real(value: object) -> TypeGuard[float]:
    return isinstance(value, Real)


class TVal:
    """Base of `Time` and `Duration`; canonical when `nsecs` is in 0 .. 999 999 999.

    Args:
        secs: Whole seconds; or seconds as a float, whose fraction is cut to nanoseconds.
        nsecs: Nanoseconds of any size and sign: they are carried into `secs`.

    Raises:
        ValueError: `secs` is a float and `nsecs` is given as well.
    """

    __slots__ = ["secs", "nsecs"]  # noqa: RUF023 - the order of the fields
    _slot_types: ClassVar[list[str]] = ["int32", "int32"]
    _peer: ClassVar[type[TVal]]

    secs: int
    nsecs: int

    def __init__(self, secs: float = 0, nsecs: int = 0) -> None:
        if type(secs) is not int and not _is_integer(secs):
            if nsecs != 0:
                raise ValueError("if secs is a float, nsecs cannot be set")
            whole = int(secs)
            nsecs = int((secs - whole) * NSEC_PER_SEC)
            secs = whole
        carried, self.nsecs = divmod(int(nsecs), NSEC_PER_SEC)
        self.secs = int(secs) + carried

    @classmethod
    def from_sec(cls, float_secs: float) -> Self:
        """The value of `float_secs` [s], as `time.time()` counts."""
        whole = int(float_secs)
        return cls(whole, int((float_secs - whole) * NSEC_PER_SEC))

    @classmethod
    def from_nsec(cls, nsec: int) -> Self:
        """The value of `nsec` nanoseconds, exactly."""
        return cls(0, nsec)

    def set(self, secs: int, nsecs: int) -> None:
        """Store both fields as they are; `canon` makes them canonical."""
        self.secs = secs
        self.nsecs = nsecs

    def canon(self) -> None:
        """Carry the nanoseconds beyond one second into the seconds."""
        carried, self.nsecs = divmod(self.nsecs, NSEC_PER_SEC)
        self.secs += carried

    def is_zero(self) -> bool:
        """Whether both fields are zero."""
        return self.secs == 0 and self.nsecs == 0

    def to_sec(self) -> float:
        """Seconds as a float; a date keeps about 0.2 microseconds of its precision."""
        return float(self.secs) + float(self.nsecs) / 1e9

    def to_nsec(self) -> int:
        """Nanoseconds, exactly."""
        return self.secs * NSEC_PER_SEC + self.nsecs

    def __hash__(self) -> int:
        return hash((self.secs, self.nsecs))

    def __str__(self) -> str:
        return str(self.to_nsec())

    def __repr__(self) -> str:
        return f"genpy.{self._peer.__name__}[{self.to_nsec()}]"

    def __bool__(self) -> bool:
        return not self.is_zero()

    def __eq__(self, other: object) -> bool:
        return isinstance(other, self._peer) and self.to_nsec() == other.to_nsec()

    def __lt__(self, other: object) -> bool:
        return self.to_nsec() < other.to_nsec() if isinstance(other, self._peer) else NotImplemented

    def __le__(self, other: object) -> bool:
        return (
            self.to_nsec() <= other.to_nsec() if isinstance(other, self._peer) else NotImplemented
        )

    def __gt__(self, other: object) -> bool:
        return self.to_nsec() > other.to_nsec() if isinstance(other, self._peer) else NotImplemented

    def __ge__(self, other: object) -> bool:
        return (
            self.to_nsec() >= other.to_nsec() if isinstance(other, self._peer) else NotImplemented
        )


class Time(TVal):
    """A point in time since the epoch; never negative.

    Args:
        secs: Whole seconds, or seconds as a float.
        nsecs: Nanoseconds, carried into `secs`.

    Raises:
        TypeError: The time is negative, as in `Time(3) - Duration(5)`.
        ValueError: `secs` is a float and `nsecs` is given as well.
    """

    __slots__ = ["secs", "nsecs"]  # noqa: RUF023 - the order of the fields

    def __init__(self, secs: float = 0, nsecs: int = 0) -> None:
        super().__init__(secs, nsecs)
        if self.secs < 0:
            raise TypeError("time values must be positive")

    @classmethod
    def from_seconds(cls, float_secs: float) -> Self:
        """Old name of `from_sec`."""
        return cls.from_sec(float_secs)

    def to_time(self) -> float:
        """Other name of `to_sec`."""
        return self.to_sec()

    def __add__(self, other: object) -> Time:
        if not isinstance(other, Duration):
            return NotImplemented
        return Time(self.secs + other.secs, self.nsecs + other.nsecs)

    __radd__ = __add__

    @overload
    def __sub__(self, other: Time) -> Duration: ...
    @overload
    def __sub__(self, other: Duration) -> Time: ...
    def __sub__(self, other: TVal) -> TVal:
        if isinstance(other, Time):
            return Duration(self.secs - other.secs, self.nsecs - other.nsecs)
        if isinstance(other, Duration):
            return Time(self.secs - other.secs, self.nsecs - other.nsecs)
        return NotImplemented


class Duration(TVal):
    """A span of time, of either sign; `nsecs` counts up from `secs` also when negative."""

    __slots__ = ["secs", "nsecs"]  # noqa: RUF023 - the order of the fields

    def __neg__(self) -> Duration:
        return Duration(-self.secs, -self.nsecs)

    def __abs__(self) -> Duration:
        return self if self.secs >= 0 else -self

    @overload
    def __add__(self, other: Time) -> Time: ...
    @overload
    def __add__(self, other: Duration) -> Duration: ...
    def __add__(self, other: TVal) -> TVal:
        if isinstance(other, Time):
            return other + self
        if isinstance(other, Duration):
            return Duration(self.secs + other.secs, self.nsecs + other.nsecs)
        return NotImplemented

    def __sub__(self, other: object) -> Duration:
        if not isinstance(other, Duration):
            return NotImplemented
        return Duration(self.secs - other.secs, self.nsecs - other.nsecs)

    def __mul__(self, factor: object) -> Duration:
        if _is_integer(factor):
            return Duration(self.secs * factor, self.nsecs * factor)
        if _is_real(factor):
            return Duration.from_sec(self.to_sec() * factor)
        return NotImplemented

    __rmul__ = __mul__

    @overload
    def __truediv__(self, divisor: Duration) -> float: ...
    @overload
    def __truediv__(self, divisor: float) -> Duration: ...
    def __truediv__(self, divisor: object) -> float | Duration:
        if isinstance(divisor, Duration):
            return self.to_sec() / divisor.to_sec()
        if _is_real(divisor):
            return Duration.from_sec(self.to_sec() / divisor)
        return NotImplemented

    @overload
    def __floordiv__(self, divisor: Duration) -> int: ...
    @overload
    def __floordiv__(self, divisor: float) -> Duration: ...
    def __floordiv__(self, divisor: object) -> int | Duration:
        if isinstance(divisor, Duration):
            return int(self.to_sec() // divisor.to_sec())
        if _is_real(divisor):
            return Duration.from_sec(self.to_sec() // divisor)
        return NotImplemented

    def __mod__(self, divisor: object) -> Duration:
        if not isinstance(divisor, Duration):
            return NotImplemented
        return Duration.from_sec(self.to_sec() % divisor.to_sec())

    def __divmod__(self, divisor: object) -> tuple[int, Duration]:
        if not isinstance(divisor, Duration):
            return NotImplemented
        quotient, rest = divmod(self.to_sec(), divisor.to_sec())
        return int(quotient), Duration.from_sec(rest)


TVal._peer = TVal
Time._peer = Time
Duration._peer = Duration
