"""The sandboxes there are, by name."""

from __future__ import annotations

import os
import shutil
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from grader.sandbox.bubblewrap import NOBODY, bubblewrap_prefix
from grader.sandbox.confinement import Confinement
from grader.sandbox.limits import node_environment, node_limits
from grader.sandbox.mounts import node_mounts

SandboxName = Literal["bubblewrap", "none"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Sandbox:
    """One way to keep a student's processes from the rest of the machine."""

    name: SandboxName
    """Name in the gradebook; "none" is a plain process under the same limits."""
    own_user: bool = False
    """Whether nodes run as a user that owns nothing, which only root can arrange."""
    private: tuple[Path, ...] = ()
    """Folders that no node may see, wherever they lie."""
    reason: str = ""
    """Why nothing stronger is used; empty for bubblewrap."""

    def confine(self, package_path: Path, home: Path) -> Confinement:
        """How to start the nodes of one submission.

        Args:
            package_path: Folder with the student's files; all that a node sees of this machine,
                besides the system, Python and simkit.
            home: Folder that nodes may write to where there is no private /tmp.
        """
        if self.name == "bubblewrap":
            mounts = node_mounts(package_path, private=self.private)
            return Confinement(
                command_prefix=bubblewrap_prefix(mounts, as_root=self.own_user),
                limits=node_limits(own_user=True),
                environment=node_environment("/tmp"),
            )
        return Confinement(
            command_prefix=_as_nobody() if self.own_user else (),
            limits=node_limits(own_user=self.own_user),
            environment=node_environment(str(home)),
        )

    def to_json(self) -> dict[str, object]:
        """As a JSON object, for the checker process."""
        private = [str(path) for path in self.private]
        return {"name": self.name, "own_user": self.own_user, "private": private}

    @classmethod
    def from_json(cls, value: dict[str, object]) -> Sandbox:
        """From `to_json`'s object."""
        name: SandboxName = "bubblewrap" if value["name"] == "bubblewrap" else "none"
        private = value["private"]
        assert isinstance(private, Sequence)
        return cls(
            name=name,
            own_user=bool(value["own_user"]),
            private=tuple(Path(str(path)) for path in private),
        )


def is_root() -> bool:
    """Whether this process may do everything on the machine."""
    return hasattr(os, "geteuid") and os.geteuid() == 0


def _as_nobody() -> tuple[str, ...]:
    program = shutil.which("setpriv") or "setpriv"
    return (program, f"--reuid={NOBODY}", f"--regid={NOBODY}", "--clear-groups", "--inh-caps=-all")


def platform_has_sandbox() -> bool:
    """Whether bubblewrap can exist here."""
    return sys.platform == "linux" and shutil.which("bwrap") is not None
