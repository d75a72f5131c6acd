"""Which controllers a request to switch stops and starts, and why it is refused.

Source: `ControllerManager::switchController`, `RobotHW::checkForConflict`, texts and order.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from simkit.errors import SimkitError, near_names
from simkit.plugins.control.controller import Controller

BEST_EFFORT = 1
"""What cannot be done is left out."""
STRICT = 2
"""All of it can be done, or nothing is."""


class SwitchRefused(SimkitError):
    """Nothing is switched.

    Args:
        text: Why, in the words of ros_control.
        hint: What would be right.
    """

    def __init__(self, text: str, hint: str = "") -> None:
        super().__init__(text)
        self.hint = hint


@dataclass(frozen=True, slots=True, kw_only=True)
class Switch:
    """What is switched, in this order."""

    stop: tuple[str, ...]
    """Names of the controllers that are stopped."""
    start: tuple[str, ...]
    """Names of those that are started."""


def plan_switch(
    loaded: Mapping[str, Controller],
    start: Sequence[str],
    stop: Sequence[str],
    strictness: int,
    warn: Callable[[str], None],
) -> Switch:
    """What a request comes to.

    Args:
        loaded: All controllers that are loaded.
        start: Names of those to be started.
        stop: Names of those to be stopped.
        strictness: STRICT or BEST_EFFORT; 0 counts as the latter.
        warn: Is given each warning.

    Raises:
        SwitchRefused: It cannot be done.
    """
    if strictness == 0:
        warn(
            "Controller Manager: To switch controllers you need to specify a strictness level of "
            "controller_manager_msgs::SwitchController::STRICT (2) or ::BEST_EFFORT (1). Defaulting to "
            "::BEST_EFFORT."
        )
    is_strict = strictness == STRICT
    stops = _known(loaded, stop, "stop", is_strict=is_strict)
    starts = _known(loaded, start, "start", is_strict=is_strict)
    for name, one in loaded.items():
        is_running = one.is_running
        if name in stops and not is_running:
            if is_strict:
                raise SwitchRefused(f"Could not stop controller '{name}' since it is not running")
            stops.remove(name)
        if name in starts and is_running and name not in stops:
            if is_strict:
                raise SwitchRefused(f"Controller '{name}' is already running")
            starts.remove(name)
    _refuse_conflicts(loaded, starts, stops, warn)
    return Switch(stop=tuple(stops), start=tuple(starts))


def _known(
    loaded: Mapping[str, Controller], names: Sequence[str], verb: str, *, is_strict: bool
) -> list[str]:
    """The names that there are, each once."""
    found: list[str] = []
    for name in names:
        if name in loaded:
            if name not in found:
                found.append(name)
        elif is_strict:
            near = near_names(name, loaded)
            there = f"load it first; loaded are: {', '.join(loaded) or 'none'}"
            hint = f"did you mean {near[0]}?" if near else there
            raise SwitchRefused(
                f"Could not {verb} controller with name '{name}' because no controller with this name "
                "exists",
                hint,
            )
    return found


def _refuse_conflicts(
    loaded: Mapping[str, Controller],
    starts: Sequence[str],
    stops: Sequence[str],
    warn: Callable[[str], None],
) -> None:
    """Refuse two controllers for one joint."""
    claimants: dict[str, list[str]] = {}
    for name, one in loaded.items():
        runs = name in starts or (one.is_running and name not in stops)
        for joint in one.claims if runs else ():
            claimants.setdefault(joint, []).append(name)
    conflicts = {joint: names for joint, names in sorted(claimants.items()) if len(names) > 1}
    for joint, names in conflicts.items():
        who = "".join(f"{name}, " for name in names)
        warn(f"Resource conflict on [{joint}].  Controllers = [{who}]")
    if conflicts:
        joint, names = next(iter(conflicts.items()))
        raise SwitchRefused(
            "Could not switch controllers, due to resource conflict",
            f"{' and '.join(names)} both command {joint}: stop one of them in the same request, or "
            "load it with the spawner's --stopped",
        )
