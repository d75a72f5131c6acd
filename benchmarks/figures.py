"""What every benchmark prints: one aligned line a figure, with its target if it has one."""

from __future__ import annotations

import statistics
from collections.abc import Sequence
from dataclasses import KW_ONLY, dataclass


@dataclass(frozen=True, slots=True)
class Figure:
    """One measured number."""

    name: str
    "What was measured."
    value: float
    "The number."
    unit: str
    "Its unit; `x` for a ratio."
    target: float | None = None
    "What it is to hold; None for a number that only explains another."
    _: KW_ONLY
    more_is_better: bool = False
    "Whether the target is a lower bound."

    @property
    def verdict(self) -> str:
        """`ok`, `over` (or `under`, for a lower bound), or nothing without a target."""
        if self.target is None:
            return ""
        if self.more_is_better:
            return "ok" if self.value >= self.target else "under"
        return "ok" if self.value <= self.target else "over"


def show(*figures: Figure) -> None:
    """Print figures, one a line."""
    for figure in figures:
        target = ""
        if figure.target is not None:
            bound = ">=" if figure.more_is_better else "<="
            target = f"{bound} {_digits(figure.target)} {figure.unit}"
        value = f"{_digits(figure.value)} {figure.unit}"
        print(f"{figure.name:<56} {value:>12}   {target:<12} {figure.verdict}".rstrip(), flush=True)


def median_of(values: Sequence[float]) -> float:
    """The middle value: what a shared machine disturbs least."""
    return statistics.median(values)


def percentile_of(values: Sequence[float], percent: int) -> float:
    """The value below which so many percent lie."""
    return statistics.quantiles(values, n=100)[percent - 1]


def _digits(value: float) -> str:
    return f"{value:.0f}" if abs(value) >= 100 else f"{value:.3g}"
