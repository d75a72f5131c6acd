"""The trees of frames for graphviz, in the form of tf2_tools' `frames.gv`."""

from __future__ import annotations

from simkit.msgs import Time
from simkit.tf.frame_report import FrameReport
from simkit.viz.forest import Forest


def dot_text(forest: Forest, now: Time | None) -> str:
    r"""The trees as a digraph; the `\n` in the labels are graphviz' own.

    Args:
        forest: The trees.
        now: Time of recording; without it there is no legend.

    Source:
        tf2_tools `view_frames.py`; it points its legend at one root only, and quotes nothing.
    """
    if not forest.trees:
        return 'digraph G { "No tf data received" }'
    reports = [node.report for tree in forest.trees for node in tree.nodes if node.report]
    lines = ["digraph G {", *(_edge(report) for report in reports)]
    if now is not None:
        roots = [_quoted(tree.nodes[0].name) for tree in forest.trees]
        target = roots[0] if len(roots) == 1 else "{" + "; ".join(roots) + "}"
        lines += [
            "edge [style=invis];",
            ' subgraph cluster_legend { style=bold; color=black; label ="view_frames Result";',
            f'"Recorded at time: {seconds(now)}"[ shape=plaintext ] ;',
            f" }}->{target};",
        ]
    return "\n".join([*lines, "}"])


def seconds(time: Time) -> str:
    """A time in seconds with three decimals."""
    return f"{time.to_sec():.3f}"


def edge_facts(report: FrameReport) -> tuple[tuple[str, str], ...]:
    """The facts of an edge with their names, in the order of tf2_tools."""
    return (
        ("Broadcaster", report.broadcaster),
        ("Average rate", f"{report.rate:.3f}"),
        ("Buffer length", f"{report.length:.3f}"),
        ("Most recent transform", f"{report.newest:.3f}"),
        ("Oldest transform", f"{report.oldest:.3f}"),
    )


def _edge(report: FrameReport) -> str:
    facts = "".join(f"{name}: {_escaped(value)}\\n" for name, value in edge_facts(report))
    return f'{_quoted(report.parent)} -> {_quoted(report.name)}[label=" {facts}"];'


def _quoted(name: str) -> str:
    return f'"{_escaped(name)}"'


def _escaped(text: str) -> str:
    return text.replace("\\", "\\\\").replace('"', '\\"')
