"""Gains of a PID from parameters.

Source: control_toolbox `Pid::init`.
"""

from __future__ import annotations

from simkit.graph.params import ParameterServer
from simkit.plugins.control.pid import Gains

NO_GAIN = "No p gain specified for pid.  Namespace: {namespace}"
"""What is said where there are none."""


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
