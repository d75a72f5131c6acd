"""Wrong and right variants of a solution, which the checks must tell apart.

`solutions/variants_3_01.toml` is a list of

    [[variant]]
    name = "parent and child swapped"
    expect = "reject"                 # or "accept": another right way
    check = "test_frame_follows_the_turtle"
    says = "turtle1 is the parent"    # must occur in that check's message or hint
    edits = [{ file = "hello_ros/scripts/a.py", old = "...", new = "..." }]

`files = { "path" = '''whole text''' }` gives whole files instead of edits, `answers = {...}` other
answers. `check` and `says` belong to "reject" only.
"""

from __future__ import annotations

import tomllib
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from grader.errors import SourceError
from grader.submission import Submission

VARIANT_KEYS = ("name", "expect", "check", "says", "edits", "files", "answers")
"""The keys of a `[[variant]]`."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Edit:
    """One replacement in a file of the solution."""

    file: str
    old: str
    """Must occur exactly once."""
    new: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Variant:
    """One variant of a solution."""

    name: str
    is_right: bool
    """Whether every check must pass."""
    check: str
    """The check that must reject it; empty for a right one."""
    says: str
    """What that check's message or hint must hold; empty for a right one."""
    edits: tuple[Edit, ...]
    files: dict[str, str]
    answers: dict[str, object]
    path: Path
    """Where it is written."""
    line: int

    def apply(self, solution: Submission) -> Submission:
        """The solution with this variant's changes.

        Raises:
            SourceError: A text to replace does not occur exactly once, or a file is not there.
        """
        files = {**solution.files, **self.files}
        for edit in self.edits:
            count = files.get(edit.file, "").count(edit.old)
            if count != 1:
                raise self.fault(
                    f"{edit.old!r} occurs {count} times in {edit.file} of the solution, not once"
                )
            files[edit.file] = files[edit.file].replace(edit.old, edit.new)
        answers = {**solution.answers, **self.answers}
        return replace(solution, files=files, answers=answers, student=self.name, notes=())

    def fault(self, text: str) -> SourceError:
        """The error about this variant."""
        return SourceError(f"variant {self.name!r}: {text}", file=self.path.name, line=self.line)


def load_variants(path: Path) -> list[Variant]:
    """The variants in a file.

    Raises:
        SourceError: The file is not TOML, or a variant has unknown, missing or wrong keys.
    """
    text = path.read_text(encoding="utf-8")
    try:
        table = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise SourceError(f"not TOML: {error}", file=path.name) from error
    if unknown := sorted(set(table) - {"variant"}):
        raise SourceError(f"unknown key `{unknown[0]}`; only [[variant]]", file=path.name)
    lines = [n for n, line in enumerate(text.split("\n"), 1) if line.strip() == "[[variant]]"]
    raw = table.get("variant", [])
    if not isinstance(raw, list) or len(raw) != len(lines):
        raise SourceError("write each variant as its own [[variant]]", file=path.name)
    variants = [_variant(one, path, line) for one, line in zip(raw, lines, strict=True)]
    names = [variant.name for variant in variants]
    for variant in variants:
        if names.count(variant.name) > 1:
            raise variant.fault("the name occurs twice")
    return variants


def _variant(raw: dict[str, Any], path: Path, line: int) -> Variant:
    def fault(text: str) -> SourceError:
        return SourceError(f"variant {raw.get('name', '?')!r}: {text}", file=path.name, line=line)

    if unknown := sorted(set(raw) - set(VARIANT_KEYS)):
        raise fault(f"unknown key `{unknown[0]}`; keys: {', '.join(VARIANT_KEYS)}")
    expect = raw.get("expect")
    if expect not in ("accept", "reject"):
        raise fault('`expect` is "accept" or "reject"')
    for key in ("name", *(("check", "says") if expect == "reject" else ())):
        if not isinstance(raw.get(key), str) or not raw[key].strip():
            raise fault(f"`{key}` is missing")
    if expect == "accept" and ("check" in raw or "says" in raw):
        raise fault("`check` and `says` have no meaning where every check must pass")
    files, answers = raw.get("files", {}), raw.get("answers", {})
    if not isinstance(files, dict) or not all(isinstance(text, str) for text in files.values()):
        raise fault("`files` is a table of path = text")
    if not isinstance(answers, dict):
        raise fault("`answers` is a table of name = value")
    edits = _edits(raw.get("edits", []))
    if edits is None:
        raise fault("`edits` is a list of {file, old, new}, all texts, `old` not empty")
    if not (edits or files or answers):
        raise fault("nothing differs from the solution: give `edits`, `files` or `answers`")
    return Variant(
        name=raw["name"],
        is_right=expect == "accept",
        check=raw.get("check", ""),
        says=raw.get("says", ""),
        edits=edits,
        files=files,
        answers=answers,
        path=path,
        line=line,
    )


def _edits(raw: object) -> tuple[Edit, ...] | None:
    """The edits; None if they are not written as they must be."""
    if not isinstance(raw, list):
        return None
    for one in raw:
        if not isinstance(one, dict) or set(one) != {"file", "old", "new"}:
            return None
        if not all(isinstance(text, str) for text in one.values()) or not one["old"]:
            return None
    return tuple(Edit(**one) for one in raw)
