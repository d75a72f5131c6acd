"""Drawing: the parts, and who may import whom."""

from __future__ import annotations

from drawing import AMBER, BLUE, GREEN, MUTED, PLAIN, VIOLET, Area, Color, Drawing

GRADER = (
    (("cli, notebook", "grader ... on the command line, check() in a notebook"),),
    (("authoring", "build, verify, start, new"), ("report", "terminal, HTML")),
    (("run", "one checker process for each submission; the gradebook"),),
    (("checks", "the pytest plugin: fixtures, points, expectations"),),
    (
        ("sandbox", "what a node may do"),
        ("submission, exercises, results", "plain data"),
    ),
)
SIMKIT = (
    (("cli", "simkit ..."), ("notebook", "% lines"), ("live", "wall's pace")),
    (("commands", "rostopic, roslaunch, ...: one function each"),),
    (("simulation", "one clock, one graph, one TF buffer"),),
    (("viz", "stage, page, still, draw"), ("launch", "and xacro")),
    (("gazebo", "a world on that clock: spawn_model, /gazebo"),),
    (("nodes", "turtlesim, ..."), ("plugins", "drives, laser, ros_control")),
    (("tf", "fed by topics"), ("physics", "rigid bodies, by DART")),
    (("graph", "executor, topics, services, parameters; process"),),
)
PURE = (
    (("urdf", "one reading of a robot, and the rules of check_urdf"),),
    (("xml", ""), ("diagnostics", ""), ("core of tf", ""), ("msgs", "")),
    (("geometry, packages, errors", ""),),
)

Rows = tuple[tuple[tuple[str, str], ...], ...]


def draw() -> str:
    """The drawing as SVG."""
    drawing = Drawing(
        "The parts, and who may import whom",
        "Layers, from top to bottom. grader: cli and notebook; authoring and report; run; checks; "
        "sandbox, submission, exercises and results. simkit: cli, notebook and live; commands; simulation; viz and launch; "
        "gazebo; nodes and plugins; tf and physics; graph; urdf; xml, diagnostics, the core of tf and msgs; geometry, "
        "packages and errors. ros1 lives in node processes and reaches the graph by its client.",
        size=(960, 926),
    )
    drawing.words((30, 36), "A part imports only from the layers below it.", size=15, bold=True)
    drawing.words((930, 36), "Along an arrow: only what it says.", color=MUTED, anchor="end")
    drawing.region(Area(30, 56, 900, 256), "grader", color=AMBER)
    _layers(drawing, GRADER, Area(50, 88, 860, 36))
    drawing.region(Area(30, 360, 560, 542), "simkit, where the simulation runs", color=BLUE)
    _layers(drawing, SIMKIT, Area(50, 392, 520, 36))
    _layers(drawing, PURE, Area(50, 752, 520, 40), color=GREEN)
    drawing.arrow([(310, 312), (310, 358)])
    drawing.words((322, 340), "public names only", size=12, color=MUTED)
    _node_side(drawing)
    return drawing.svg()


def _layers(drawing: Drawing, rows: Rows, first: Area, *, color: Color = PLAIN) -> None:
    """Rows of flat boxes; `first` is where the first row lies."""
    gap = 8.0
    for number, row in enumerate(rows):
        width = (first.width - gap * (len(row) - 1)) / len(row)
        y = first.y + number * (first.height + gap)
        for column, (title, note) in enumerate(row):
            area = Area(first.x + column * (width + gap), y, width, first.height)
            drawing.layer(area, title, note, color=color)


def _node_side(drawing: Drawing) -> None:
    drawing.region(Area(690, 360, 240, 542), "in each node process", color=VIOLET)
    drawing.box(
        Area(708, 394, 204, 56), "a student's script", lines=["real ROS 1 Python"], color=VIOLET
    )
    drawing.box(
        Area(708, 662, 204, 106),
        "ros1",
        lines=["rospy, tf,", "turtlesim.msg, std_srvs.srv, ..."],
    )
    drawing.arrow([(810, 450), (810, 660)])
    drawing.words((820, 560), "import rospy", size=12, color=MUTED)
    drawing.arrow([(708, 718), (572, 718)])
    drawing.words((640, 692), "client,", size=12, color=MUTED, anchor="middle")
    drawing.words((640, 708), "protocol", size=12, color=MUTED, anchor="middle")
    drawing.arrow([(810, 768), (810, 820), (572, 820)])
    drawing.words((640, 839), "all of it", size=12, color=MUTED, anchor="middle")
