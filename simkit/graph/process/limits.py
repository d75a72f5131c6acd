"""What one node process may use."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from typing import Any

MIB = 1024 * 1024


@dataclass(frozen=True, slots=True, kw_only=True)
class NodeLimits:
    """Limits of one node process; None leaves the system's own."""

    cpu_seconds: int | None = None
    """Processor time over the process's whole life [s]."""
    memory_bytes: int | None = None
    """Address space [bytes]."""
    processes: int | None = None
    """Processes and threads of the user at the same time; the kernel does not hold root to it."""
    open_files: int | None = None
    """Open file descriptors."""
    file_bytes: int | None = None
    """Size of any file it writes [bytes]."""
    output_bytes: int = 8 * MIB
    """What it may print; a node that prints more is stopped [bytes]."""

    def to_json(self) -> dict[str, int | None]:
        """As a JSON object."""
        return asdict(self)

    @classmethod
    def from_json(cls, value: dict[str, Any]) -> NodeLimits:
        """From `to_json`'s object."""
        return cls(**value)


def apply_limits(limits: NodeLimits) -> None:
    """Hold the calling process to `limits`, where the platform can."""
    try:
        import resource
    except (
        ImportError
    ):  # Windows has no rlimits: the reader of the output and the allowance still hold
        return
    wanted = {
        resource.RLIMIT_CPU: limits.cpu_seconds,
        resource.RLIMIT_AS: limits.memory_bytes,
        resource.RLIMIT_NPROC: limits.processes,
        resource.RLIMIT_NOFILE: limits.open_files,
        resource.RLIMIT_FSIZE: limits.file_bytes,
        resource.RLIMIT_CORE: 0,
    }
    for kind, value in wanted.items():
        if value is not None:
            _set_limit(kind, value)


def _set_limit(kind: int, value: int) -> None:
    import resource

    _, hard = resource.getrlimit(kind)
    if hard != resource.RLIM_INFINITY:
        value = min(value, hard)
    resource.setrlimit(kind, (value, value))
