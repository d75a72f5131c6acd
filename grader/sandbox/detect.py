"""Find the strongest sandbox that works here, by a trial: what is installed may still be forbidden."""

from __future__ import annotations

import functools
import subprocess
import sys
import tempfile
from dataclasses import replace
from pathlib import Path

from grader.errors import SandboxError
from grader.sandbox.sandbox import Sandbox, is_root, platform_has_sandbox

TRIAL_SECONDS = 10.0
_TRIAL = "import simkit, pathlib, sys; pathlib.Path(sys.argv[1], 'seen').read_bytes()"
INSTALL = "install bubblewrap (apt install bubblewrap) and allow user namespaces"


def find_sandbox(*, private: tuple[Path, ...] = (), require: bool = False) -> Sandbox:
    """The strongest sandbox that works on this machine.

    Args:
        private: Folders that no node may see, such as the workbook and the submissions.
        require: Whether to refuse a plain process.

    Raises:
        SandboxError: A sandbox is required and none works; the text has the reason and the remedy.
    """
    found = _strongest()
    if require and found.name == "none":
        raise SandboxError(f"no sandbox works here: {found.reason}; {INSTALL}")
    return replace(found, private=tuple(path.resolve() for path in private))


@functools.cache
def _strongest() -> Sandbox:
    own_user = is_root()
    if not platform_has_sandbox():
        reason = "bubblewrap is not installed" if sys.platform == "linux" else "only Linux has one"
    else:
        bubblewrap = Sandbox(name="bubblewrap", own_user=own_user)
        failure = _trial(bubblewrap)
        if failure is None:
            return bubblewrap
        reason = f"bubblewrap does not run: {failure}"
    plain = Sandbox(name="none", own_user=own_user, reason=reason)
    if own_user and _trial(plain) is not None:
        return replace(plain, own_user=False)
    return plain


def _trial(sandbox: Sandbox) -> str | None:
    """Run Python in the sandbox; why it failed, or None."""
    with tempfile.TemporaryDirectory(prefix="trial-") as folder:
        package_path = Path(folder)
        package_path.chmod(0o755)
        (package_path / "seen").touch()
        confinement = sandbox.confine(package_path, package_path)
        command = [*confinement.command_prefix, sys.executable, "-c", _TRIAL, folder]
        try:
            done = subprocess.run(
                command,
                env=confinement.environment,
                stdin=subprocess.DEVNULL,
                capture_output=True,
                timeout=TRIAL_SECONDS,
                check=False,
            )
        except (OSError, subprocess.TimeoutExpired) as error:
            return str(error)
    if done.returncode == 0:
        return None
    lines = done.stderr.decode(errors="replace").strip().splitlines()
    return lines[-1][:200] if lines else f"exit code {done.returncode}"
