"""Build the notebooks of a workbook from their sources, or say which ones are stale."""

from __future__ import annotations

from pathlib import Path

from grader.authoring.lectures import FOLDER, built_lectures
from grader.authoring.notebook_text import solution_notebook, student_notebook
from grader.authoring.source import load_source, source_paths
from grader.errors import SourceError


def build(root: Path) -> list[Path]:
    """Write every notebook that differs from its source.

    Args:
        root: Folder of the workbook.

    Returns:
        The files that were written.

    Raises:
        SourceError: A source has a fault; nothing was written then.
    """
    stale = [(path, text) for path, text in built_notebooks(root).items() if not _is(path, text)]
    for path, text in stale:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text.encode("utf-8"))
    return [path for path, _ in stale]


def check(root: Path) -> list[str]:
    """A sentence for each notebook that is not what its source says.

    Raises:
        SourceError: A source has a fault.
    """
    built = built_notebooks(root)
    sentences = [
        f"{_short(path, root)} is {'stale' if path.exists() else 'missing'}; run `grader build`"
        for path, text in built.items()
        if not _is(path, text)
    ]
    for folder in ("exercises", "solutions", FOLDER):
        for path in sorted((root / folder).glob("*.ipynb")):
            if path not in built:
                source = f"{FOLDER if folder == FOLDER else 'solutions'}/{path.stem}.md"
                sentences.append(f"{_short(path, root)} has no source {source}; delete it")
    return sentences


def built_notebooks(root: Path) -> dict[Path, str]:
    """File -> text of every notebook that the sources make.

    Raises:
        SourceError: A source has a fault.
    """
    built: dict[Path, str] = {}
    ids: dict[str, str] = {}
    for path in source_paths(root):
        source = load_source(path)
        other = ids.setdefault(source.definition.id, path.name)
        if other != path.name:
            raise SourceError(f"{other} is exercise {source.definition.id} too", file=path.name)
        built[root / "exercises" / f"{source.slug}.ipynb"] = student_notebook(source)
        built[root / "solutions" / f"{source.slug}.ipynb"] = solution_notebook(source)
    return built | built_lectures(root)


def _is(path: Path, text: str) -> bool:
    return path.is_file() and path.read_bytes() == text.encode("utf-8")


def _short(path: Path, root: Path) -> str:
    return path.relative_to(root).as_posix()
