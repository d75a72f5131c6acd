"""Log calls: to rosout, formatted as Python's logging does."""

from __future__ import annotations

import io
import sys
from collections.abc import Callable
from typing import Any

from simkit.graph.process import client
from simkit.graph.process.failure import print_traceback

from .exceptions import ROSInterruptException

DEBUG, INFO, WARN, ERROR, FATAL = 1, 2, 4, 8, 16
_threshold = INFO
_last_logged: dict[tuple[Any, ...], tuple[int, str]] = {}


def set_level(level: int) -> None:
    """Publish only lines of at least this level."""
    global _threshold
    _threshold = level


def _log(level: int, msg: object, args: tuple[Any, ...]) -> None:
    if level < _threshold:
        return
    text = str(msg)
    if args:
        try:
            text = text % (args[0] if len(args) == 1 and isinstance(args[0], dict) else args)
        except (TypeError, ValueError, KeyError) as error:
            # Python's logging, on which rospy stands, does not let a wrong format end the program.
            place = sys._getframe(2)
            where = f'  File "{place.f_code.co_filename}", line {place.f_lineno}'
            print(
                f"--- Logging error ---\n{where}\n{type(error).__name__}: {error}", file=sys.stderr
            )
            return
    client.current().log(level, text + _hints((msg, *args)))


def _hints(values: tuple[Any, ...]) -> str:
    """The hints of errors that a script logs, each on a line of its own."""
    hints = [getattr(value, "hint", "") for value in values if isinstance(value, BaseException)]
    return "".join(f"\nhint: {hint}" for hint in hints if isinstance(hint, str) and hint)


def _plain(level: int) -> Callable[..., None]:
    def log(msg: object, *args: Any, **_options: Any) -> None:
        """Log a line on rosout; `%` arguments may follow."""
        _log(level, msg, args)

    return log


def _place() -> tuple[Any, ...]:
    # Throttling counts per place in the script, as rospy does.
    frame = sys._getframe(2)
    return frame.f_code.co_filename, frame.f_lineno


def _throttled(level: int) -> Callable[..., None]:
    def log(period: float, msg: object, *args: Any, **_options: Any) -> None:
        """Log a line on rosout, at most once in `period` [s] from one place of the script."""
        key, now = (_place(), level), client.current().peek_ns()
        last = _last_logged.get(key)
        if last is None or now - last[0] > round(period * 1e9):
            _last_logged[key] = (now, "")
            _log(level, msg, args)

    return log


def _throttled_identical(level: int) -> Callable[..., None]:
    def log(period: float, msg: object, *args: Any, **_options: Any) -> None:
        """Log a line on rosout; the same text again only after `period` [s]."""
        key, now = (_place(), level, "identical"), client.current().peek_ns()
        last = _last_logged.get(key)
        if last is None or last[1] != str(msg) or now - last[0] > round(period * 1e9):
            _last_logged[key] = (now, str(msg))
            _log(level, msg, args)

    return log


def _once(level: int) -> Callable[..., None]:
    def log(msg: object, *args: Any, **_options: Any) -> None:
        """Log a line on rosout the first time only."""
        key = (_place(), level, "once")
        if key not in _last_logged:
            _last_logged[key] = (0, "")
            _log(level, msg, args)

    return log


logdebug, loginfo, logwarn, logerr, logfatal = map(_plain, (DEBUG, INFO, WARN, ERROR, FATAL))
logout, logerror = loginfo, logerr
logdebug_throttle, loginfo_throttle, logwarn_throttle, logerr_throttle, logfatal_throttle = map(
    _throttled, (DEBUG, INFO, WARN, ERROR, FATAL)
)
(
    logdebug_throttle_identical,
    loginfo_throttle_identical,
    logwarn_throttle_identical,
    logerr_throttle_identical,
    logfatal_throttle_identical,
) = map(_throttled_identical, (DEBUG, INFO, WARN, ERROR, FATAL))
logdebug_once, loginfo_once, logwarn_once, logerr_once, logfatal_once = map(
    _once, (DEBUG, INFO, WARN, ERROR, FATAL)
)


def report_bad_callback(callback: object, error: BaseException) -> None:
    """Report that a callback raised, as rospy does, and let the node go on."""
    if isinstance(error, ROSInterruptException) and client.current().shutdown_reason is not None:
        return  # the shutdown ended its wait: no fault
    stream = io.StringIO()
    print_traceback(error, stream)
    client.current().log(ERROR, f"bad callback: {callback}\n{stream.getvalue()}")
    client.current().report_fault(error)
