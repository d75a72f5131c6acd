"""Who may import whom: the tables are the rules, and every module of simkit and grader is walked."""

from __future__ import annotations

import ast
import importlib
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest

from simkit import msgs
from tests.laws import broken_laws

ROOT = Path(__file__).resolve().parents[1]

# A part is a module or package, without the parts below it that have a row of their own. It may
# import itself and the parts beside it here, and nothing else of ours.
MAY_IMPORT = {
    # pure: no node, no clock
    "simkit.errors": "",
    "simkit.geometry": "",
    "simkit.msgs": "simkit.errors",
    "simkit.tf": "simkit.errors simkit.msgs",
    "simkit.xml": "simkit.errors",
    "simkit.diagnostics": "simkit.errors simkit.xml",
    "simkit.urdf": "simkit.errors simkit.xml simkit.diagnostics simkit.packages simkit.tf "
    "simkit.plugins.tags simkit.plugins.registry simkit.plugins.control.registry",
    # the graph, and what lives on it
    "simkit.graph": "simkit.errors simkit.msgs simkit.graph.process.child",
    "simkit.tf.broadcaster": "simkit.msgs simkit.tf simkit.graph",
    "simkit.tf.listener": "simkit.msgs simkit.tf simkit.graph",
    # command lines: what nodes use of them too, then the commands
    "simkit.commands.errors": "simkit.errors",
    "simkit.commands.parser": "simkit.commands.errors",
    "simkit.commands.parameter_yaml": "simkit.commands.errors",
    "simkit.commands.graph_facts": "simkit.graph",
    "simkit.commands.topic_pub": "simkit.errors simkit.msgs simkit.graph simkit.commands.errors simkit.commands.graph_facts",
    "simkit.commands": "simkit",
    "simkit.nodes.program": "simkit.graph",
    "simkit.nodes.rostopic": "simkit.graph simkit.msgs simkit.commands simkit.commands.errors simkit.commands.topic_pub "
    "simkit.nodes.program",
    "simkit.nodes": "simkit.errors simkit.msgs simkit.graph simkit.tf simkit.packages "
    "simkit.commands.errors simkit.commands.parser simkit.commands.parameter_yaml simkit.nodes.program",
    # programs with a window load the view when it is looked at
    "simkit.nodes.rviz": "simkit.errors simkit.graph simkit.packages simkit.commands.errors simkit.nodes.program simkit.viz",
    "simkit.nodes.tf_tools.view_frames": "simkit.graph simkit.msgs simkit.tf simkit.tf.listener simkit.nodes.program simkit.viz",
    "simkit.nodes.robot_state_publisher": "simkit.errors simkit.msgs simkit.graph simkit.tf "
    "simkit.nodes.program simkit.urdf",
    "simkit.nodes.joint_state_publisher": "simkit.errors simkit.msgs simkit.graph simkit.nodes.program "
    "simkit.xml",
    "simkit.physics": "simkit.errors simkit.xml simkit.diagnostics simkit.urdf simkit.packages simkit.tf",
    # what the tags of plugins may say: pure, so that check_urdf and the plugins' parser share it
    "simkit.plugins.tags": "simkit.plugins.registry",
    "simkit.plugins.control.registry": "simkit.plugins",
    "simkit.plugins.registry": "simkit.plugins simkit.plugins.tags",
    "simkit.plugins": "simkit.plugins.tags simkit.plugins.registry simkit.plugins.control.registry simkit.errors "
    "simkit.msgs simkit.graph "
    "simkit.tf simkit.xml simkit.urdf simkit.physics",
    "simkit.gazebo": "simkit.errors simkit.msgs simkit.graph simkit.tf simkit.xml simkit.diagnostics "
    "simkit.urdf simkit.urdf.rules simkit.packages simkit.commands.errors simkit.nodes.program "
    "simkit.physics simkit.plugins simkit.plugins.registry simkit.plugins.tags",
    "simkit.launch": "simkit.errors simkit.msgs simkit.graph simkit.tf simkit.xml simkit.diagnostics "
    "simkit.urdf simkit.urdf.rules simkit.packages simkit.nodes simkit.commands.errors simkit.commands.parameter_yaml "
    "simkit.xacro",
    "simkit.packages": "simkit.errors",
    "simkit.xacro": "simkit.errors simkit.packages",
    "simkit.simulation": "simkit.errors simkit.msgs simkit.graph simkit.tf simkit.tf.listener simkit.nodes simkit.packages "
    "simkit.commands.topic_pub simkit.gazebo simkit.launch simkit.physics simkit.urdf simkit.viz "
    "simkit.nodes.joint_state_publisher simkit.nodes.rviz simkit.nodes.gzclient",
    # pictures of what is known; a simulation hands them out, lazily
    "simkit.viz": "simkit.errors simkit.msgs simkit.graph simkit.tf simkit.diagnostics "
    "simkit.nodes simkit.nodes.joint_state_publisher simkit.packages simkit.physics simkit.urdf simkit.urdf.rules simkit.xml",
    # on top: a simulation on the clock of the wall, and the command line
    "simkit.live": "simkit.errors simkit.launch simkit.msgs simkit.graph simkit.tf simkit.nodes "
    "simkit.launch simkit.nodes.joint_state_publisher simkit.packages "
    "simkit.simulation simkit.commands simkit.commands.errors",
    "simkit.cli": "simkit",
    "simkit.notebook": "simkit",
    # inside a node process: the node's side of the graph, and the pure parts
    "simkit.graph.process.child": "simkit.graph simkit.ros1",
    "simkit.ros1": "simkit.errors simkit.msgs simkit.tf simkit.tf.listener "
    "simkit.graph.process.client simkit.graph.process.node_client simkit.graph.process.protocol "
    "simkit.graph.process.failure",
    # the grader, from plain data up; what it may use of simkit is below
    "grader.errors": "",
    "grader.results": "grader.errors",
    "grader.exercises": "grader.errors grader.submission",
    "grader.submission": "grader.errors grader.exercises",
    "grader.sandbox": "grader.errors",
    "grader.checks": "grader.errors grader.results grader.exercises grader.submission grader.sandbox",
    "grader.run": "grader.errors grader.results grader.exercises grader.submission grader.sandbox "
    "grader.checks",
    "grader.report": "grader.errors grader.results grader.exercises grader.run",
    "grader.last_checks": "grader.results grader.exercises",
    "grader.authoring": "grader.errors grader.results grader.exercises grader.submission "
    "grader.sandbox grader.run grader.last_checks",
    "grader.notebook": "grader.errors grader.results grader.exercises grader.submission "
    "grader.sandbox grader.run grader.report grader.last_checks",
    "grader.commands": "grader",
    "grader.cli": "grader",
    # what the checks of the course share
    "oracles": "grader.checks grader.errors",
}

# Every part of simkit may import these.
EVERYWHERE = ("simkit.geometry",)

# The package's `__init__` hands out the names of its own modules.
HANDS_OUT = ("simkit", "simkit.tf", "grader")

# grader imports these of simkit, and of the packages only what their `__all__` lists.
SIMKIT_FOR_GRADER = (
    "simkit simkit.errors simkit.graph simkit.graph.process simkit.msgs simkit.nodes simkit.tf "
    "simkit.diagnostics simkit.gazebo simkit.packages simkit.physics simkit.urdf simkit.urdf.rules "
    "simkit.xml"
)
EXCEPTIONS = {
    ("grader.run.checker", "simkit.simulation"): "loaded once by the warm parent, before it forks",
}

# Where a library may be imported: by these modules at once, by those only inside of functions.
# A library without a row may be imported nowhere.
LIBRARIES = {
    "numpy": (
        "simkit.physics simkit.plugins simkit.tf.transformations simkit.viz",
        "simkit.graph.process.virtual_time simkit.urdf.mesh_file",
    ),
    "transformations": ("simkit.tf.transformations", ""),
    "yaml": (
        "simkit.commands",
        "simkit.graph.names simkit.msgs.strify simkit.launch simkit.urdf.rules simkit.viz.stage.rviz_config",
    ),
    "matplotlib": ("simkit.viz", ""),
    "PIL": ("", "simkit.viz.draw.files"),
    "dartpy": ("", "simkit.physics"),
    "meshcat": ("", "simkit.viz.page.meshcat_window"),
    "umsgpack": ("", "simkit.viz.page.meshcat_window"),
    "trimesh": ("", "simkit.urdf.mesh_file"),
    "yourdfpy": ("", "simkit.urdf.yourdfpy_robot"),
    "xacro": ("", "simkit.xacro.child"),
    "tornado": ("simkit.viz.page.live_server", ""),
    "ipywidgets": ("", "simkit.viz"),
    "anywidget": ("simkit.viz.widgets.scene_widget", "simkit.viz"),
    "traitlets": ("simkit.viz.widgets.scene_widget", "simkit.viz"),
    "rosbags": ("", "simkit.msgs.generate"),
    "pytest": ("grader.checks grader.run.checker", ""),
    "rich": ("", "grader.report"),
    "IPython": ("simkit.notebook", "simkit.viz"),
    "jupytext": ("", "grader.authoring"),
}

# In a node process the modules of this folder, and those of messages, are there under ROS's names.
ROS_NAMES = {path.name for path in (ROOT / "simkit/ros1").iterdir()} | set(msgs.packages())

# Clocks and chance: who may know of them, and what for.
CLOCKS_AND_CHANCE = {
    "time": {
        "simkit.graph.process.link": "ends a script that is stuck",
        "simkit.graph.process.starters": "gives up on an interpreter that does not start",
        "simkit.graph.process.process_tree": "waits for a process that was killed",
        "simkit.graph.process.virtual_time": "replaces it in node processes",
        "simkit.live.host": "keeps a live simulation in step with the wall",
        "simkit.live.session": "waits for a simulation that another terminal is starting",
        "simkit.live.keyboard": "looks at the keyboard now and then",
        "simkit.viz.turtlesim.view": "draws no oftener than the eye can follow, and never for most of the time",
        "simkit.viz.widgets": "sends moments to a notebook no oftener than it can take them",
        "simkit.cli": "keeps it in step too",
        "simkit.commands.doctor": "measures how long a node takes to start",
        "grader.run.supervise": "ends a checker that is stuck",
    },
    "datetime": {"simkit.graph.process.virtual_time": "replaces it in node processes"},
    "random": {
        "simkit.graph.process.virtual_time": "seeds it in node processes",
        "simkit.nodes.joint_state_publisher.gui": "draws positions, from the seed of its node",
        "grader.checks.fixtures": "makes the generator of a check, from its seed",
        "grader.checks.personal": "draws a student's own numbers, from the name",
    },
    "secrets": {
        "simkit.live.host": "makes the password of a live simulation",
        "simkit.viz.page.live_server": "makes the password of a live view",
    },
    "uuid": {},
}

# What a first import must not load, since it would be slow; name -> (statement, libraries).
COLD = {
    "simkit": ("import simkit", "numpy matplotlib yaml rosbags rich pytest jupytext nbformat"),
    "messages": ("import simkit.msgs", "numpy matplotlib yaml rosbags rich pytest"),
    "a simulation": (
        "import simkit; simkit.Simulation(screen=None).run(1)",
        "numpy matplotlib rosbags rich pytest jupytext nbformat",
    ),
    "a robot without a window": (
        "import simkit; sim = simkit.Simulation(package_path=['robots'], screen=None); "
        "sim.roslaunch('my_robot_urdf', 'spawn_urdf.launch'); sim.run(1.0)",
        "simkit.viz simkit.graph.process yaml matplotlib trimesh ipywidgets anywidget meshcat yourdfpy PIL pytest",
    ),
    "grader": ("import grader", "numpy matplotlib yaml rich pytest jupytext nbformat simkit.graph"),
    "check": ("from grader import check", "numpy matplotlib rich pytest jupytext nbformat"),
    "the command line": ("import grader.cli", "numpy matplotlib rich pytest jupytext nbformat"),
}


@dataclass(frozen=True, slots=True)
class Import:
    """One name that a module imports."""

    module: str
    target: str
    """Module that is imported, or that the name is taken from."""
    name: str
    """The name that is taken from it; empty if the module itself is imported."""
    lazy: bool
    """Whether it stands in a function, or is for type checkers only."""
    line: int

    def __str__(self) -> str:
        return (
            f"{self.module}:{self.line} imports {'.'.join(filter(None, (self.target, self.name)))}"
        )


def module_files() -> dict[str, Path]:
    folders = {"simkit": ROOT, "grader": ROOT, "oracles": ROOT / "exercises"}
    return {
        ".".join(path.relative_to(above).with_suffix("").parts).removesuffix(".__init__"): path
        for name, above in folders.items()
        for path in sorted(above.glob(f"{name}/**/*.py"))
    }


FILES = module_files()


def imports_of(module: str) -> Iterator[Import]:
    tree = ast.parse(FILES[module].read_bytes())
    package = module if FILES[module].name == "__init__.py" else module.rpartition(".")[0]
    yield from _imports_below(tree, module, package, lazy=False)


def _imports_below(node: ast.AST, module: str, package: str, *, lazy: bool) -> Iterator[Import]:
    for child in ast.iter_child_nodes(node):
        if isinstance(child, ast.Import):
            for alias in child.names:
                yield Import(module, alias.name, "", lazy, child.lineno)
        elif isinstance(child, ast.ImportFrom):
            base = child.module or ""
            if child.level:
                above = package.split(".")[: len(package.split(".")) - child.level + 1]
                base = ".".join([*above, *filter(None, [base])])
            for alias in child.names:
                inner = f"{base}.{alias.name}"
                found = (inner, "") if inner in FILES else (base, alias.name)
                yield Import(module, *found, lazy, child.lineno)
        is_function = isinstance(child, ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda)
        is_typing = isinstance(child, ast.If) and "TYPE_CHECKING" in ast.unparse(child.test)
        yield from _imports_below(child, module, package, lazy=lazy or is_function or is_typing)


TABLES = "tests/test_imports.py"
ABOVE = (
    f"the table is MAY_IMPORT in {TABLES}. Of what lies above, let the caller hand it in, or ask the graph; "
    "what both need moves below both; a new arrow downwards is a word in the row"
)

OUR_PACKAGES = ("simkit", "grader", "oracles")
IMPORTS = [found for module in FILES for found in imports_of(module)]
OURS = [found for found in IMPORTS if found.target.split(".")[0] in OUR_PACKAGES]


def is_in(module: str, packages: str) -> bool:
    return any(module == name or module.startswith(f"{name}.") for name in packages.split())


def part_of(module: str) -> str:
    rows = [row for row in MAY_IMPORT if is_in(module, row)]
    return max(rows, key=len, default=module)


def test_every_module_belongs_to_a_part():
    rootless = [m for m in FILES if m not in ("simkit", "grader") and part_of(m) not in MAY_IMPORT]
    broken_laws(rootless, f"give its package a row in MAY_IMPORT in {TABLES}: what it may import")


def test_no_row_is_for_something_that_is_gone():
    named = [("MAY_IMPORT", row) for row in MAY_IMPORT]
    for at_once, later in LIBRARIES.values():
        named += [("LIBRARIES", name) for name in f"{at_once} {later}".split()]
    named += [("CLOCKS_AND_CHANCE", name) for row in CLOCKS_AND_CHANCE.values() for name in row]
    gone = [row for row in named if not any(is_in(module, row[1]) for module in FILES)]
    used = {(found.module, found.target) for found in OURS}
    gone += [("EXCEPTIONS", " imports ".join(pair)) for pair in EXCEPTIONS if pair not in used]
    broken_laws(gone, f"nothing of this name is there: take it out of its table in {TABLES}")


def test_parts_import_only_what_is_below_them():
    wrong = []
    for found in OURS:
        part, target = part_of(found.module), part_of(found.target)
        own = found.module in HANDS_OUT and is_in(found.target, found.module)
        # What the grader and the oracles may use of simkit has a law of its own.
        same_world = is_in(found.module, "simkit") or not is_in(found.target, "simkit")
        if part == target or own or not same_world or found.target in ("simkit", "grader"):
            continue
        allowed = [*EVERYWHERE, *MAY_IMPORT.get(part, "").split()]
        if not {target, found.target, found.target.split(".")[0]} & set(allowed):
            wrong.append(f"{found}; {part} may import: {' '.join(allowed) or 'nothing of ours'}")
    broken_laws(wrong, ABOVE)


def test_simkit_knows_nothing_of_the_grader():
    wrong = [one for one in OURS if is_in(one.module, "simkit") and is_in(one.target, "grader")]
    broken_laws(wrong, "simkit runs without the grader: let the grader hand in what it needs")


def test_grader_uses_the_public_names_of_simkit():
    wrong = []
    for found in OURS:
        if is_in(found.module, "simkit") or not is_in(found.target, "simkit"):
            continue
        if (found.module, found.target) in EXCEPTIONS:
            continue
        names = getattr(importlib.import_module(found.target), "__all__", None)
        is_public = found.target in SIMKIT_FOR_GRADER.split()
        if not is_public or (found.name and names is not None and found.name not in names):
            wrong.append(str(found))
    broken_laws(
        wrong,
        f"the grader takes what is in `__all__` of the packages in SIMKIT_FOR_GRADER in {TABLES}: "
        "add the name to its package's `__all__`, or use what is there",
    )


def test_no_private_name_crosses_a_package():
    wrong = []
    for found in OURS:
        home = (
            found.target
            if FILES.get(found.target, Path()).name == "__init__.py"
            else found.target.rpartition(".")[0]
        )
        parts = [*found.target.split("."), found.name]
        is_private = any(part.startswith("_") and not part.startswith("__") for part in parts)
        if is_private and not is_in(found.module, home):
            wrong.append(str(found))
    broken_laws(
        wrong,
        "a name with _ belongs to its package: drop the _, or ask a public name of the package",
    )


def test_nothing_imports_tests_exercises_or_solutions():
    outside = "tests exercises solutions docs benchmarks work"
    wrong = [found for found in IMPORTS if is_in(found.target, outside)]
    broken_laws(wrong, "what tests and exercises share with the packages lives in the packages")


def test_libraries_stay_where_they_belong():
    wrong = []
    for found in IMPORTS:
        library = found.target.split(".")[0]
        if library in sys.stdlib_module_names or library in OUR_PACKAGES:
            continue
        if library in ROS_NAMES and is_in(found.module, "simkit.ros1"):
            continue
        at_once, later = LIBRARIES.get(library, ("", ""))
        allowed = f"{at_once} {later}" if found.lazy else at_once
        if not is_in(found.module, allowed):
            wrong.append(str(found))
    broken_laws(
        wrong,
        f"LIBRARIES in {TABLES} says which modules may import a library, at once or inside of a function: "
        "ask one of those modules, or add yours to the row and say why in docs/architecture.md",
    )


def test_clocks_and_chance_stay_where_they_belong():
    wrong = [
        str(found)
        for found in IMPORTS
        if found.target in CLOCKS_AND_CHANCE
        and not is_in(found.module, " ".join(CLOCKS_AND_CHANCE[found.target]))
    ]
    broken_laws(
        wrong,
        "time is that of the simulation (`node.now()`, timers, `sim.run`) and chance comes from a seed "
        f"(`site.seed`, `sim.seed`), so that each run is the same; exceptions: CLOCKS_AND_CHANCE in {TABLES}",
    )


@pytest.mark.parametrize("name", COLD)
def test_a_first_import_loads_nothing_heavy(name):
    statement, libraries = COLD[name]
    program = f"import sys; {statement}; print(*sys.modules)"
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True, cwd=ROOT
    )
    broken_laws(
        sorted(set(libraries.split()) & set(done.stdout.split())),
        f"`{statement}` shall not load it: import it inside of the function that needs it "
        "(`python -X importtime` shows who does)",
    )
