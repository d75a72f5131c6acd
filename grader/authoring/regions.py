"""Regions that only the solution shows: from `# solution: what to do` to `# end solution`.

In XML the marks are comments of XML, `<!-- solution: what to do -->`. Each stands alone on its
line. The solution loses the two lines of marks; the student's version has `# TODO: what to do`
(or `<!-- TODO: ... -->`) in place of the region, and a `pass` where Python would break without.

A region may end with a faulty text for students to find and mend, behind the mark `# instead`
(`<!-- instead -->`). They get that text as it is, without a TODO that would point at the fault.
"""

from __future__ import annotations

import re
import warnings
from collections.abc import Callable
from dataclasses import dataclass

_OPEN = re.compile(
    r"(?P<indent>[ \t]*)(?P<sign>#|<!--) solution:(?P<prompt>.*?)(?P<end>-->)?[ \t]*"
)
_CLOSE = re.compile(r"[ \t]*(?:# end solution|<!-- end solution -->)[ \t]*")
_INSTEAD = re.compile(r"[ \t]*(?:# instead|<!-- instead -->)[ \t]*")
_NEARLY = re.compile(r"(?i)[ \t]*(?:#|<!--)[ \t]*(?:end[ \t_-]*(?:of[ \t]+)?)?solution\b.*")


class RegionError(ValueError):
    """A mark is misspelt, unpaired or nested; `line` counts from 1 within the text."""

    def __init__(self, text: str, line: int) -> None:
        self.line = line
        super().__init__(text)


@dataclass(frozen=True, slots=True, kw_only=True)
class Region:
    """What lies between two marks."""

    start: int
    """Index of the line with the opening mark, from 0."""
    stop: int
    """Index of the line with the closing mark."""
    indent: str
    """Blanks before the opening mark."""
    prompt: str
    """What the student is to do."""
    is_xml: bool
    body: tuple[str, ...]
    """The lines that only the solution has."""
    instead: tuple[str, ...] | None = None
    """The lines that students get in their place; None for a note of what to do."""

    @property
    def body_stop(self) -> int:
        """Index of the line behind the body: the mark `instead`, or the closing one."""
        return self.start + 1 + len(self.body)

    def for_students(self, *, needs_pass: bool) -> list[str]:
        """The lines that students get in place of the whole region."""
        if self.instead is not None:
            return list(self.instead)
        return [self.todo()] + [f"{self.indent}pass"] * needs_pass

    def todo(self) -> str:
        """The line that the student finds instead."""
        text = f"<!-- TODO: {self.prompt} -->" if self.is_xml else f"# TODO: {self.prompt}"
        return self.indent + text


def find_regions(text: str) -> list[Region]:
    """The regions of a text, in order.

    Raises:
        RegionError: A mark is misspelt, says nothing, is nested in another, or is not closed.
    """
    lines = text.split("\n")
    regions: list[Region] = []
    opened: tuple[int, re.Match[str]] | None = None
    for index, line in enumerate(lines):
        if mark := _OPEN.fullmatch(line):
            if opened is not None:
                raise RegionError(f"a region within the one of line {opened[0] + 1}", index + 1)
            opened = (index, mark)
        elif _CLOSE.fullmatch(line):
            if opened is None:
                raise RegionError("`end solution` without a `solution:` above it", index + 1)
            regions.append(_region(lines, opened[0], index, opened[1]))
            opened = None
        elif _NEARLY.fullmatch(line):
            raise RegionError(
                f"{line.strip()!r} is nearly a mark; write `# solution: what to do` or"
                " `# end solution`",
                index + 1,
            )
    if opened is not None:
        raise RegionError("the region is not closed by `# end solution`", opened[0] + 1)
    return regions


def _region(lines: list[str], start: int, stop: int, mark: re.Match[str]) -> Region:
    prompt, is_xml = mark["prompt"].strip(), mark["sign"] != "#"
    if not prompt:
        raise RegionError("`solution:` must say what the student is to do", start + 1)
    if is_xml != (mark["end"] is not None):
        raise RegionError("the mark is not one whole comment", start + 1)
    body, instead = _parts(lines, start, stop)
    if not any(line.strip() for line in body):
        raise RegionError("the region is empty", start + 1)
    return Region(
        start=start,
        stop=stop,
        indent=mark["indent"],
        prompt=prompt,
        is_xml=is_xml,
        body=body,
        instead=instead,
    )


def _parts(
    lines: list[str], start: int, stop: int
) -> tuple[tuple[str, ...], tuple[str, ...] | None]:
    marks = [index for index in range(start + 1, stop) if _INSTEAD.fullmatch(lines[index])]
    if len(marks) > 1:
        raise RegionError("a second `instead` in one region", marks[1] + 1)
    if not marks:
        return tuple(lines[start + 1 : stop]), None
    return tuple(lines[start + 1 : marks[0]]), tuple(lines[marks[0] + 1 : stop])


def solution_text(text: str) -> str:
    """The text without its marks."""
    left_out = {
        index
        for region in find_regions(text)
        for index in (region.start, *range(region.body_stop, region.stop + 1))
    }
    lines = text.split("\n")
    return "\n".join(line for index, line in enumerate(lines) if index not in left_out)


def student_text(text: str, *, is_valid: Callable[[str], bool] | None = None) -> str:
    """The text with a note of what to do in place of each region.

    Args:
        text: With marks.
        is_valid: Whether a text is sound Python; None if it is no Python.

    Raises:
        RegionError: As `find_regions`; or even with `pass` in all regions it is not sound.
    """
    regions = find_regions(text)
    if is_valid is None or is_valid(_replaced(text, regions, passes=frozenset())):
        return _replaced(text, regions, passes=frozenset())
    passes = frozenset(region.start for region in regions)
    if not regions or not is_valid(_replaced(text, regions, passes=passes)):
        line = regions[0].start + 1 if regions else 1
        raise RegionError("without its regions this is not valid Python; mark whole blocks", line)
    for region in regions:
        fewer = passes - {region.start}
        if is_valid(_replaced(text, regions, passes=fewer)):
            passes = fewer
    return _replaced(text, regions, passes=passes)


def _replaced(text: str, regions: list[Region], *, passes: frozenset[int]) -> str:
    lines = text.split("\n")
    for region in reversed(regions):
        new = region.for_students(needs_pass=region.start in passes)
        lines[region.start : region.stop + 1] = new
    return "\n".join(lines)


def is_python(text: str) -> bool:
    """Whether a text compiles as a module."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            compile(text, "<student>", "exec", dont_inherit=True)
    except (SyntaxError, ValueError):
        return False
    return True


def is_notebook_python(text: str) -> bool:
    """Whether a cell compiles, magics and shell lines aside."""
    if text.lstrip().startswith("%%"):
        return True
    return is_python(re.sub(r"^([ \t]*)[%!].*$", r"\1pass", text, flags=re.MULTILINE))
