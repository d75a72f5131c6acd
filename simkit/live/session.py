"""How terminals find the running simulation: a small file with a port and a secret, readable by its owner only.

It stands for what ROS_MASTER_URI is to ROS. The secret keeps other users of the machine, and web pages, away from the port.
"""

from __future__ import annotations

import contextlib
import json
import os
import tempfile
import time
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from pathlib import Path

from simkit.errors import SimkitError

FILE_VARIABLE = "SIMKIT_SESSION"
"""Environment variable with the path of the session file, for several simulations at once."""

PATIENCE = 5.0
"""How long a command waits for a simulation that another terminal is starting [s]."""
_PERIOD = 0.05


class SessionError(SimkitError):
    """No simulation runs, or it does not answer."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Session:
    """Where a simulation listens."""

    port: int
    """Port on the loopback interface."""
    token: str
    """Secret that a request must carry."""
    pid: int
    """Process id of the host."""


def session_file() -> Path:
    """Path of the session file of this user."""
    if given := os.environ.get(FILE_VARIABLE):
        return Path(given)
    user = os.getuid() if hasattr(os, "getuid") else os.environ.get("USERNAME", "user")
    return Path(tempfile.gettempdir()) / f"simkit-{user}" / "session.json"


def own_folder() -> Path:
    """The folder of the session file, which is this user's alone; makes it.

    Raises:
        SessionError: It belongs to somebody else, who could put there what they like.
    """
    folder = session_file().parent
    folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    if hasattr(os, "getuid") and folder.stat().st_uid != os.getuid():
        raise SessionError(
            f"{folder} belongs to another user; set {FILE_VARIABLE} to a file of yours"
        )
    return folder


@contextlib.contextmanager
def announced(session: Session) -> Iterator[None]:
    """Publish a session while the body runs.

    Raises:
        SessionError: The folder for it belongs to somebody else.
    """
    path = own_folder() / session_file().name
    new = path.with_suffix(f".{session.pid}")
    descriptor = os.open(new, os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o600)
    with os.fdopen(descriptor, "w") as file:
        json.dump(asdict(session), file)
    new.replace(path)
    _coming_up_file().unlink(missing_ok=True)
    try:
        yield
    finally:
        if _read(path) == session:
            path.unlink(missing_ok=True)


@contextlib.contextmanager
def coming_up() -> Iterator[None]:
    """Let commands of other terminals wait, while the body runs, until it has announced a session."""
    file = _coming_up_file()
    with contextlib.suppress(OSError, SessionError):  # then nobody waits
        own_folder()
        file.touch()
    try:
        yield
    finally:
        with contextlib.suppress(OSError):
            file.unlink(missing_ok=True)


def find_session(patience: float = 0.0) -> Session | None:
    """The session that is announced, or None.

    Args:
        patience: How long to wait for one that is coming up [s], since it began to.
    """
    while (session := _read(session_file())) is None and _is_coming_up(patience):
        time.sleep(_PERIOD)
    return session


def _coming_up_file() -> Path:
    return session_file().with_suffix(".starting")


def _is_coming_up(patience: float) -> bool:
    """Whether another terminal began to start a simulation so short a time ago; one that was killed leaves its file."""
    try:
        return 0.0 <= time.time() - _coming_up_file().stat().st_mtime < patience
    except OSError:
        return False


def _read(path: Path) -> Session | None:
    try:
        if hasattr(os, "getuid") and path.stat().st_uid != os.getuid():
            return None
        value = json.loads(path.read_text())
        return Session(port=int(value["port"]), token=str(value["token"]), pid=int(value["pid"]))
    except (OSError, ValueError, KeyError, TypeError):
        return None
