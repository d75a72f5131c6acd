"""A controller of proportion, integral and derivative."""

from __future__ import annotations

import math
from dataclasses import dataclass

from simkit.graph.params import ParameterServer


@dataclass(frozen=True, slots=True, kw_only=True)
class Gains:
    """What a PID multiplies with; the units are those of the command per unit of the error."""

    p: float
    """Of the error."""
    i: float = 0.0
    """Of its integral [per s]."""
    d: float = 0.0
    """Of its derivative [s]."""
    i_max: float = 0.0
    """Largest part of the command that the integral makes."""
    i_min: float = 0.0
    """Smallest part of the command that the integral makes."""
    antiwindup: bool = False
    """Whether the integral itself stops at its limits, so that it turns back at once."""


class Pid:
    """Makes a command of an error, step by step.

    Args:
        gains: What it multiplies with.

    Source:
        control_toolbox `Pid`: `computeCommand`.
    """

    def __init__(self, gains: Gains) -> None:
        self.gains = gains
        self._integral = 0.0
        self._last_error = 0.0

    def reset(self) -> None:
        """Forget all errors."""
        self._integral = self._last_error = 0.0

    def command(self, error: float, period_s: float, *, rate: float | None = None) -> float:
        """The command for an error.

        Args:
            error: Target minus state.
            period_s: Time since the last command [s].
            rate: How fast the error grows [per s]; from the last error if None.

        Returns:
            The command; 0 if no time has passed, or a number is NaN or infinite.
        """
        if period_s <= 0.0 or not math.isfinite(error):
            return 0.0
        if rate is None:
            rate, self._last_error = (error - self._last_error) / period_s, error
        elif not math.isfinite(rate):
            return 0.0
        gains = self.gains
        self._integral += period_s * error
        if gains.antiwindup and gains.i != 0.0:
            ends = sorted((gains.i_min / gains.i, gains.i_max / gains.i))
            self._integral = min(max(self._integral, ends[0]), ends[1])
        share = gains.i * self._integral
        if not gains.antiwindup:
            share = min(max(share, gains.i_min), gains.i_max)
        return gains.p * error + share + gains.d * rate


NO_GAIN = "No p gain specified for pid.  Namespace: {namespace}"
"""The error for missing gains."""


def read_gains(params: ParameterServer, namespace: str) -> Gains | None:
    """The gains in a namespace; None if there is no `p`, or a value is no number."""
    found = params.get(namespace, {})
    if not isinstance(found, dict) or not _is_number(found.get("p")):
        return None
    numbers = {key: float(value) for key, value in found.items() if _is_number(value)}
    most = abs(numbers.get("i_clamp", 0.0))
    return Gains(
        p=numbers["p"],
        i=numbers.get("i", 0.0),
        d=numbers.get("d", 0.0),
        i_max=numbers.get("i_clamp_max", most),
        i_min=numbers.get("i_clamp_min", -most),
        antiwindup=bool(found.get("antiwindup", False)),
    )


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)
