from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from grader.authoring.variants import load_variants
from grader.errors import SourceError
from grader.submission import Submission


def solution() -> Submission:
    return Submission(
        student="", exercise_id="3.1", files={"a.py": "one two two"}, answers={"frame": "world"}
    )


def load(tmp_path: Path, text: str) -> Any:
    path = tmp_path / "variants_3_01.toml"
    path.write_text(text)
    return load_variants(path)


HEAD = '[[variant]]\nname = "x"\nexpect = "reject"\ncheck = "test_a"\nsays = "b"\n'


def test_edits_files_and_answers_change_the_solution(tmp_path: Path) -> None:
    text = HEAD + (
        'edits = [{ file = "a.py", old = "one", new = "1" }]\n'
        'answers = { frame = "map" }\nfiles = { "b.py" = "new" }\n'
    )
    (variant,) = load(tmp_path, text)
    changed = variant.apply(solution())
    assert changed.files == {"a.py": "1 two two", "b.py": "new"}
    assert changed.answers == {"frame": "map"}
    assert not variant.is_right
    assert solution().files == {"a.py": "one two two"}


@pytest.mark.parametrize(("old", "count"), [("two", 2), ("three", 0)])
def test_what_is_replaced_must_occur_once(tmp_path: Path, old: str, count: int) -> None:
    text = "\n\n" + HEAD + f'edits = [{{ file = "a.py", old = "{old}", new = "" }}]'
    (variant,) = load(tmp_path, text)
    with pytest.raises(SourceError, match=f"{old!r} occurs {count} times in a.py") as caught:
        variant.apply(solution())
    assert (caught.value.file, caught.value.line) == ("variants_3_01.toml", 3)


EDIT = 'edits = [{ file = "a.py", old = "one", new = "1" }]\n'


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("[[variant]", "not TOML"),
        ("[other]", "unknown key `other`"),
        ("variant = [1]", "as its own"),
        (HEAD, "nothing differs"),
        (HEAD + EDIT + "colour = 1", "unknown key `colour`"),
        (HEAD.replace("reject", "refuse") + EDIT, "`expect` is"),
        (HEAD.replace('says = "b"\n', "") + EDIT, "`says` is missing"),
        (HEAD.replace('name = "x"\n', "") + EDIT, "`name` is missing"),
        (HEAD.replace("reject", "accept") + EDIT, "have no meaning"),
        (HEAD + 'edits = [{ file = "a.py" }]', "`edits` is a list"),
        (HEAD + 'edits = [{ file = "a.py", old = "", new = "" }]', "`edits` is a list"),
        (HEAD + "edits = 7", "`edits` is a list"),
        (HEAD + "files = { a = 1 }", "`files` is a table"),
        (HEAD + "answers = 1", "`answers` is a table"),
        (HEAD + EDIT + HEAD + EDIT, "the name occurs twice"),
    ],
)
def test_a_wrong_file_is_refused_by_name(tmp_path: Path, text: str, says: str) -> None:
    with pytest.raises(SourceError, match=says) as caught:
        load(tmp_path, text)
    assert caught.value.file == "variants_3_01.toml"


def test_edits_may_be_tables_of_their_own(tmp_path: Path) -> None:
    table = '[[variant.edits]]\nfile = "a.py"\nold = "one"\nnew = "1"\n'
    (variant,) = load(tmp_path, HEAD + table)
    assert variant.apply(solution()).files == {"a.py": "1 two two"}
