"""Which exercises a workbook has, and what each asks for.

The definition of an exercise is the `workbook` table in the metadata of the *released* notebook
`exercises/<slug>.ipynb`, which `grader build` copies there from the source. A submission is never
asked: its metadata may say at most which exercise it belongs to.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

from grader.errors import GraderError, SourceError, SubmissionError
from grader.submission.files import collect_files
from grader.submission.notebook import Notebook, read_notebook
from simkit.errors import UnknownNameError

ID_PATTERN = re.compile(r"[0-9A-Z]\.[1-9][0-9]?")
"""What an exercise id looks like: "3.1", "3.10", "S.1"."""
SLUG_PATTERN = re.compile(r"([0-9a-z])_([0-9]{2})_[a-z0-9_]+")
"""What the name of a source or notebook looks like, without its ending: "3_01_broadcast_a_tf"."""
DEFINITION_KEYS = ("id", "title", "package", "files", "answers", "nodes_may")
"""The keys of a `workbook` table."""


@dataclass(frozen=True, slots=True, kw_only=True)
class NodesMay:
    """What the nodes of an exercise may write; all else is refused."""

    publish: tuple[str, ...] = ()
    """Topics, as resolved names, e.g. "/tf"."""
    services: tuple[str, ...] = ()
    """Services they may call, e.g. "/spawn"."""
    parameters: tuple[str, ...] = ()
    """Parameters they may set, and a launch file too."""
    launch: tuple[str, ...] = ()
    """Built-in nodes that a launch file may start, e.g. "turtlesim/turtlesim_node"."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Exercise:
    """One exercise: what is handed in, and where its checks are."""

    id: str
    """E.g. "3.1"."""
    slug: str
    """Name of its notebooks without ending, e.g. "3_01_broadcast_a_tf"."""
    title: str
    package: str
    """The ROS package the student works in, e.g. "hello_ros"."""
    files: tuple[str, ...]
    """Deliverables: paths relative to `work/`, e.g. "hello_ros/scripts/listener.py"."""
    answers: tuple[str, ...]
    """Names the student assigns a literal to, e.g. "fixed_frame"."""
    permissions: NodesMay
    public_checks: Path
    """File of the checks that the student can run."""
    hidden_checks: Path | None
    """File of the checks that run at grading only; None in a student's release."""
    stub_files: dict[str, str]
    """Path -> text of every file that the released notebook writes."""

    @property
    def packages(self) -> frozenset[str]:
        """Top folders that a submission may write to."""
        return _packages(self.package, self.files)

    @property
    def oracles(self) -> list[Path]:
        """Modules that the checks of all exercises may import, from `oracles/` beside the public ones."""
        return sorted((self.public_checks.parent / "oracles").glob("*.py"))


def exercise_key(exercise_id: str) -> str:
    """The part of file names that stands for the exercise: "3.1" -> "3_01", "S.1" -> "s_01"."""
    chapter, number = exercise_id.split(".")
    return f"{chapter.lower()}_{int(number):02d}"


def find_root(start: Path) -> Path:
    """The folder of the workbook: `start` or the nearest one above it that has `exercises/`.

    Raises:
        GraderError: There is none.
    """
    start = Path(start).resolve()
    for folder in (start, *start.parents):
        if (folder / "exercises").is_dir():
            return folder
    raise GraderError(
        f"no workbook at {start} or above it (a folder with exercises/);"
        " go to the folder of the course, or give it with --root"
    )


def load_exercises(root: Path) -> dict[str, Exercise]:
    """Every exercise of the workbook by id, in the order of its chapters and numbers.

    Raises:
        SourceError: A notebook in `exercises/` is not as `grader build` makes it.
    """
    exercises: dict[str, Exercise] = {}
    for path in sorted((root / "exercises").glob("*.ipynb")):
        exercise = _load(path, root)
        if exercise.id in exercises:
            other = exercises[exercise.id].slug
            raise SourceError(f"{exercise.id} is also the id of {other}.ipynb", file=path.name)
        exercises[exercise.id] = exercise
    return exercises


def get_exercise(root: Path, exercise_id: str) -> Exercise:
    """The exercise with this id.

    Raises:
        UnknownNameError: There is none; lists near and known ids.
    """
    exercises = load_exercises(root)
    if exercise_id not in exercises:
        raise UnknownNameError("exercise", exercise_id, exercises)
    return exercises[exercise_id]


def _load(path: Path, root: Path) -> Exercise:
    try:
        notebook = read_notebook(path)
    except SubmissionError as error:
        raise SourceError(str(error), file=path.name) from error
    return exercise_from_notebook(notebook, path=path, root=root)


def exercise_from_notebook(notebook: Notebook, *, path: Path, root: Path) -> Exercise:
    """The exercise that a released notebook defines.

    Args:
        notebook: The notebook of students.
        path: Its file; the stem is the exercise's slug.
        root: Folder of the workbook.

    Raises:
        SourceError: Its `workbook` table is missing or wrong.
    """
    definition = notebook.metadata.get("workbook")
    try:
        table = require_definition(definition)
    except ValueError as error:
        raise SourceError(f"{error}; run `grader build`", file=path.name) from error
    key = exercise_key(table.id)
    hidden = root / "solutions" / f"test_{key}_hidden.py"
    return Exercise(
        id=table.id,
        slug=path.stem,
        title=table.title,
        package=table.package,
        files=table.files,
        answers=table.answers,
        permissions=table.nodes_may,
        public_checks=root / "exercises" / f"test_{key}.py",
        hidden_checks=hidden if hidden.is_file() else None,
        stub_files=collect_files(notebook, packages=table.packages, wanted=table.files).files,
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class Definition:
    """The `workbook` table: what an author says about an exercise."""

    id: str
    title: str
    package: str
    files: tuple[str, ...]
    answers: tuple[str, ...]
    nodes_may: NodesMay

    @property
    def packages(self) -> frozenset[str]:
        """Top folders that a submission may write to."""
        return _packages(self.package, self.files)


def _packages(package: str, files: tuple[str, ...]) -> frozenset[str]:
    return frozenset([package, *(path.split("/")[0] for path in files)])


def require_definition(table: object) -> Definition:
    """The definition in a `workbook` table.

    Raises:
        ValueError: A key is missing, unknown, or has a wrong value; the message says which.
    """
    if not isinstance(table, dict):
        raise ValueError("no table `workbook:` in the front matter or metadata")
    if unknown := sorted(str(key) for key in set(table) - set(DEFINITION_KEYS)):
        raise ValueError(
            f"unknown key `{unknown[0]}` in workbook; keys: {', '.join(DEFINITION_KEYS)}"
        )
    exercise_id = _required_text(table, "id")
    if not ID_PATTERN.fullmatch(exercise_id):
        raise ValueError(f"`id: {exercise_id}` is not like 3.1, 3.10 or S.1 (put it in quotes)")
    definition = Definition(
        id=exercise_id,
        title=_required_text(table, "title"),
        package=_required_text(table, "package"),
        files=_texts(table, "files"),
        answers=_texts(table, "answers"),
        nodes_may=_nodes_may(table.get("nodes_may", {})),
    )
    if not (definition.files or definition.answers):
        raise ValueError("`files` and `answers` are both empty: nothing would be handed in")
    return definition


def _required_text(table: dict[str, object], key: str) -> str:
    value = table.get(key)
    if not isinstance(value, str) or not value.strip():
        raise ValueError(f"`{key}` is missing in workbook, or is not a text (quotes help)")
    return value


def _texts(table: dict[str, object], key: str) -> tuple[str, ...]:
    value = table.get(key, [])
    if not isinstance(value, list) or not all(isinstance(item, str) and item for item in value):
        raise ValueError(f"`{key}` must be a list of texts")
    if len(set(value)) != len(value):
        raise ValueError(f"`{key}` names something twice")
    return tuple(value)


def _nodes_may(value: object) -> NodesMay:
    allowed = ("publish", "services", "parameters", "launch")
    if not isinstance(value, dict) or not set(value) <= set(allowed):
        raise ValueError(f"`nodes_may` has the keys {', '.join(allowed)} (lists of names)")
    return NodesMay(**{key: _texts(value, key) for key in allowed})
