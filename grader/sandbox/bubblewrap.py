"""The command line of bubblewrap: no network, no other process, no file but those of `Mounts`.

Two ways lead to the same place. An ordinary user gets a user namespace. Root mounts without one,
since the workbook may lie where only root can look; then `setpriv` becomes a user that owns
nothing, and a second, inner bubblewrap takes away the right to make namespaces.
"""

from __future__ import annotations

import shutil
from pathlib import Path

from grader.sandbox.limits import TEMPORARY_BYTES
from grader.sandbox.mounts import Mounts, system_links

NOBODY = 64123
"""User and group of a node: an unusual number, so that nothing on the machine is theirs."""
_EMPTY_BYTES = 4096
_TEMPORARY = Path("/tmp")  # inside of the sandbox only


def bubblewrap_prefix(mounts: Mounts, *, as_root: bool) -> tuple[str, ...]:
    """Command prefix that runs a command inside of the sandbox.

    The environment is passed on: whoever runs it starts from a clean one.

    Args:
        mounts: What the command sees of this machine.
        as_root: Whether the caller is root.
    """
    command = [_program("bwrap"), *_namespaces(as_root=as_root), *_file_system(mounts)]
    command += ["--chdir", "/tmp", "--"]
    if as_root:
        command += _become_nobody()
    return tuple(command)


def _namespaces(*, as_root: bool) -> list[str]:
    common = ["--die-with-parent", "--new-session"]
    if as_root:
        apart = ["ipc", "pid", "net", "uts", "cgroup-try"]
        return [
            *common,
            *(f"--unshare-{name}" for name in apart),
            *("--cap-add", "CAP_SETUID", "--cap-add", "CAP_SETGID"),
        ]
    user = ["--unshare-user", "--disable-userns", "--uid", str(NOBODY), "--gid", str(NOBODY)]
    return [*common, "--unshare-all", *user]


def _become_nobody() -> list[str]:
    user = [f"--reuid={NOBODY}", f"--regid={NOBODY}", "--clear-groups", "--inh-caps=-all"]
    inner = ["--die-with-parent", "--unshare-user", "--disable-userns", "--dev-bind", "/", "/"]
    return [_program("setpriv"), *user, _program("bwrap"), *inner, "--"]


def _file_system(mounts: Mounts) -> list[str]:
    command = [part for target, path in system_links() for part in ("--symlink", target, str(path))]
    command += ["--proc", "/proc", "--dev", "/dev", "--remount-ro", "/dev"]
    command += ["--size", str(TEMPORARY_BYTES), "--perms", "1777", "--tmpfs", str(_TEMPORARY)]
    mounted: set[Path] = set()
    for path, shown in mounts.in_order():
        command += _parents(path, mounted)
        if shown:
            command += ["--ro-bind", str(path), str(path)]
        else:
            command += ["--size", str(_EMPTY_BYTES), "--perms", "0755", "--tmpfs", str(path)]
        mounted.add(path)
    empty = [path for path, shown in mounts.in_order() if not shown]
    command += [part for path in empty for part in ("--remount-ro", str(path))]
    return [*command, "--remount-ro", "/"]


def _parents(path: Path, mounted: set[Path]) -> list[str]:
    # Made by us, since bubblewrap would close them to anybody but the one who mounts.
    missing: list[Path] = []
    for parent in path.parents:
        if parent in mounted or parent in (Path("/"), _TEMPORARY):
            break
        missing.append(parent)
        mounted.add(parent)
    return [
        part for folder in reversed(missing) for part in ("--perms", "0755", "--dir", str(folder))
    ]


def _program(name: str) -> str:
    # As a plain name if missing: the trial run then fails, and says so.
    return shutil.which(name) or name
