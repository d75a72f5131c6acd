"""Read MyST Markdown with jupytext."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from grader.errors import SourceError


def parsed_myst(path: Path) -> tuple[Any, list[str]]:
    """The notebook that jupytext makes of a file, with its map of lines, and the file's lines.

    Raises:
        SourceError: The file is not MyST Markdown.
    """
    # Imported here: it takes half a second, which only authors need to wait for.
    from jupytext.myst import myst_to_notebook  # type: ignore[import-untyped]

    text = path.read_text(encoding="utf-8")
    try:
        parsed = myst_to_notebook(text, add_source_map=True)
    except Exception as error:  # whatever the parser says, it is about this file
        raise SourceError(f"not MyST Markdown: {error}", file=path.name) from error
    return parsed, text.split("\n")
