"""Drawing: the life of a grade, and the line that no trust crosses."""

from __future__ import annotations

from drawing import AMBER, BLUE, GREEN, MUTED, PLAIN, RED, VIOLET, Area, Drawing


def draw() -> str:
    """The drawing as SVG."""
    drawing = Drawing(
        "The life of a grade",
        "The runner reads a notebook as JSON, without running it, and sends files and answers to "
        "a checker process. The checker runs pytest, the simulation and the checks; the student's "
        "scripts run as sandboxed node processes that it reaches by topics, services and "
        "parameters alone. Verdicts go back as JSON lines and into the gradebook.",
        size=(960, 600),
    )
    drawing.words((30, 36), "From a notebook to a gradebook", size=15, bold=True)
    drawing.words((930, 36), "one row for each process", color=MUTED, anchor="end")
    _runner(drawing)
    _checker(drawing)
    _nodes(drawing)
    _wires(drawing)
    return drawing.svg()


def _runner(drawing: Drawing) -> None:
    drawing.region(
        Area(30, 56, 900, 130), "runner: grader grade, or check() in a notebook", color=AMBER
    )
    drawing.box(Area(50, 96, 160, 70), "notebook", lines=["as handed in, in", "any state"])
    drawing.box(
        Area(254, 96, 190, 70),
        "read, never run",
        lines=["plain JSON, bounded:", "files and answers"],
    )
    drawing.box(
        Area(488, 96, 190, 70),
        "supervise",
        lines=["wall time, sizes, shape", "of what it receives"],
    )
    drawing.box(
        Area(722, 96, 188, 70),
        "gradebook",
        lines=["SQLite, then JSON;", "a table for people"],
        color=GREEN,
    )
    drawing.arrow([(210, 131), (252, 131)])
    drawing.arrow([(678, 131), (720, 131)])


def _checker(drawing: Drawing) -> None:
    drawing.region(Area(30, 240, 900, 130), "checker process", color=BLUE)
    drawing.words((284, 262), "one for each submission to each exercise", size=12, color=MUTED)
    drawing.box(Area(50, 280, 190, 70), "lay out the files", lines=["as a ROS package,", "as data"])
    drawing.box(
        Area(284, 280, 230, 70),
        "simulation",
        lines=["clock, topics, services,", "parameters, turtlesim"],
    )
    drawing.box(
        Area(558, 280, 352, 70),
        "checks (pytest)",
        lines=["watch the graph, ask an oracle,", "say what was wrong and what to try"],
    )
    drawing.arrow([(240, 315), (282, 315)])
    drawing.arrow([(556, 306), (516, 306)])
    drawing.arrow([(514, 326), (554, 326)])


def _nodes(drawing: Drawing) -> None:
    drawing.region(
        Area(30, 440, 900, 130),
        "sandbox: the student's code, and nothing of ours but simkit",
        color=RED,
        dashed=True,
    )
    drawing.box(
        Area(284, 480, 230, 70),
        "warm parent",
        lines=["has imported rospy and tf;", "forks a node in milliseconds"],
        color=PLAIN,
    )
    drawing.box(Area(558, 480, 168, 70), "node process", lines=["broadcaster.py"], color=VIOLET)
    drawing.box(Area(742, 480, 168, 70), "node process", lines=["listener.py"], color=VIOLET)
    drawing.words((50, 490), "no network, no home,", size=12, color=MUTED)
    drawing.words((50, 508), "no other submission,", size=12, color=MUTED)
    drawing.words((50, 526), "no solution, no check;", size=12, color=MUTED)
    drawing.words((50, 544), "limits on all it uses", size=12, color=MUTED)
    drawing.arrow([(514, 515), (556, 515)])


def _wires(drawing: Drawing) -> None:
    drawing.arrow([(349, 166), (349, 214), (200, 214), (200, 278)])
    drawing.words((214, 206), "the job, as JSON", size=12, color=MUTED)
    drawing.arrow([(734, 280), (734, 214), (583, 214), (583, 168)])
    drawing.words((596, 206), "verdicts, as JSON lines", size=12, color=MUTED)
    drawing.line([(30, 405), (930, 405)], color=RED.edge, width=2, dashed=True)
    drawing.words((930, 398), "trust ends here", size=12.5, color=RED.edge, bold=True, anchor="end")
    drawing.arrow([(430, 350), (430, 392), (642, 392), (642, 478)])
    drawing.arrow([(620, 478), (620, 418), (400, 418), (400, 352)])
    drawing.words((656, 427), "frames: messages, service calls, parameters", size=12, color=MUTED)
