"""What a buffer holds, as text: as YAML, and as a graph for graphviz."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from simkit.tf.cache import LATEST
from simkit.tf.frame_tree import NO_FRAME, FrameTable


@dataclass(frozen=True, slots=True, kw_only=True)
class FrameReport:
    """What is known about one frame that has a parent."""

    name: str
    "The frame."
    parent: str
    "Its parent, by the newest transform."
    broadcaster: str
    "Node that sent the newest stored transform."
    rate: float
    "Transforms per second of stamps [Hz]; 10000 times their number if there is no span."
    newest: float
    "Newest stamp [s]; 0 for a static frame."
    oldest: float
    "Oldest stamp [s]; 0 for a static frame."
    length: float
    "Time from the oldest to the newest stamp [s]."


def frame_reports(table: FrameTable) -> Iterator[FrameReport]:
    """Reports of all frames that have data, in order of appearance."""
    for number, cache in enumerate(table.caches):
        edge = cache.at(LATEST) if cache else None
        if cache is None or edge is None or number == NO_FRAME:
            continue
        oldest, newest = cache.span
        yield FrameReport(
            name=table.names[number],
            parent=table.names[edge[0]],
            broadcaster=table.authorities.get(number, "no recorded authority"),
            rate=len(cache) / max(newest / 1e9 - oldest / 1e9, 0.0001),
            newest=newest / 1e9,
            oldest=oldest / 1e9,
            length=(newest - oldest) / 1e9,
        )


def as_yaml(table: FrameTable, now: float = 0.0) -> str:
    """A mapping from each frame that has data to its report.

    Args:
        table: The frames.
        now: Current time [s]; if positive, the age of the newest transform is shown.

    Source:
        tf2 `BufferCore::allFramesAsYAML`.
    """
    if not table.known_names:
        return "{}"
    return "".join(_yaml_block(report, now) for report in frame_reports(table))


def _yaml_block(report: FrameReport, now: float) -> str:
    lines = [
        f"{report.name}: ",
        f"  parent: '{report.parent}'",
        f"  broadcaster: '{report.broadcaster}'",
        f"  rate: {report.rate:.3f}",
        f"  most_recent_transform: {report.newest:.3f}",
        f"  oldest_transform: {report.oldest:.3f}",
    ]
    if now > 0.0:
        lines.append(f"  transform_delay: {now - report.newest:.3f}")
    lines.append(f"  buffer_length: {report.length:.3f}")
    return "\n".join(lines) + "\n"


def as_dot(table: FrameTable, now: float = 0.0) -> str:
    r"""The tree in graphviz' language; the `\n` in the labels are graphviz' own.

    Args:
        table: The frames.
        now: Current time [s]; if positive, ages and the time of recording are shown.

    Source:
        tf2 `BufferCore::_allFramesAsDot`.
    """
    parts = ["digraph G {\n"]
    if not table.known_names:
        parts.append('"no tf data recieved"')
    parts += [_dot_edge(report, now) for report in frame_reports(table)]
    for number, name in enumerate(table.known_names, start=1):
        cache = table.caches[number]
        if (cache is None and now > 0.0) or (cache is not None and not cache):
            parts.append(_dot_legend(name, now))
    return "".join(parts) + "}"


def _dot_edge(report: FrameReport, now: float) -> str:
    age = f"( {now - report.newest:.3f} sec old)" if now > 0.0 else ""
    return (
        f'"{report.parent}" -> "{report.name}"[label="Broadcaster: {report.broadcaster}\\n'
        f"Average rate: {report.rate:.3f} Hz\\n"
        f"Most recent transform: {report.newest:.3f} {age}\\n"
        f'Buffer length: {report.length:.3f} sec\\n"];\n'
    )


def _dot_legend(root: str, now: float) -> str:
    recorded = f'"Recorded at time: {now:.3f}"[ shape=plaintext ] ;\n ' if now > 0.0 else ""
    return (
        "edge [style=invis];\n"
        ' subgraph cluster_legend { style=bold; color=black; label ="view_frames Result";\n'
        f'{recorded}}}->"{root}";\n'
    )
