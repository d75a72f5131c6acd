"""A result as HTML: one card for each check, self-contained, everything of a student escaped."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape
from itertools import groupby

from grader.report.style import PAGE_STYLE, STYLE
from grader.report.words import ICONS, explained, number, summary
from grader.results import CheckResult, ExerciseResult, Status


def exercise_html(result: ExerciseResult, *, title: str = "", hidden_to_come: bool = False) -> str:
    """One exercise as a piece of HTML, for the output of a notebook's cell.

    Args:
        result: What came out.
        title: Title of the exercise.
        hidden_to_come: Whether only public checks ran, and hidden ones run at grading.
    """
    name = f"Exercise {result.exercise_id}" + (f": {title}" if title else "")
    return (
        f"<style>{STYLE}</style>"
        f'<section class="grader" aria-label="{escape(name)}">'
        f'<div class="head"><strong>{escape(name)}</strong>'
        f'<span class="sum">{escape(summary(result, hidden_to_come=hidden_to_come))}</span></div>'
        f'<ol class="cards">{_cards(result.checks)}</ol>{_notes(result.notes)}</section>'
    )


def message_html(text: str) -> str:
    """A sentence instead of results: why nothing could be checked."""
    return (
        f"<style>{STYLE}</style>"
        '<section class="grader"><ol class="cards"><li class="infrastructure">'
        f'<div class="row"><span class="title">{escape(text)}</span></div></li></ol></section>'
    )


def page(title: str, pieces: Sequence[str]) -> str:
    """A whole page around pieces of HTML; it loads nothing from anywhere."""
    body = "\n".join(pieces)
    return (
        '<!doctype html>\n<html lang="en"><head><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width, initial-scale=1">'
        f"<title>{escape(title)}</title><style>{PAGE_STYLE}</style></head>\n"
        f"<body><h1>{escape(title)}</h1>\n{body}\n</body></html>\n"
    )


def _cards(checks: Sequence[CheckResult]) -> str:
    """A card for each check; skipped ones that follow each other lie folded in one, and wait for the same cause."""
    cards = []
    for is_skipped, group in groupby(checks, lambda check: check.status is Status.SKIPPED):
        row = [_card(check) for check in group]
        if is_skipped and len(row) > 1:
            inner = f'<ol class="cards">{"".join(row)}</ol>'
            summary = f"{ICONS[Status.SKIPPED]} {len(row)} checks skipped"
            row = [
                f'<li class="skipped"><details><summary>{summary}</summary>{inner}</details></li>'
            ]
        cards += row
    return "".join(cards)


def _card(check: CheckResult) -> str:
    kind = check.status.value.replace(" ", "-")
    points = f"{number(check.points)} / {number(check.max_points)}"
    hidden = " (hidden check)" if check.hidden else ""
    return (
        f'<li class="{kind}"><div class="row">'
        f'<span class="chip"><b aria-hidden="true">{ICONS[check.status]}</b>'
        f"{escape(check.status.value)}</span>"
        f'<span class="title">{escape(check.title)}{hidden}</span>'
        f'<span class="points" aria-label="{points} points">{points}</span></div>'
        f"{_more(check)}</li>"
    )


def _more(check: CheckResult) -> str:
    """Why a check did not pass, and what to do."""
    if not (check.message or check.hint):
        return ""
    sentences, values = explained(check)
    text = f"<p>{escape(chr(10).join(sentences))}</p>" if sentences else ""
    rows = "".join(f"<dt>{label}</dt><dd>{escape(value)}</dd>" for label, value in values.items())
    table = f"<dl>{rows}</dl>" if rows else ""
    hint = (
        f"<details open><summary>Hint</summary><p>{escape(check.hint)}</p></details>"
        if check.hint
        else ""
    )
    return f'<div class="more">{text}{table}{hint}</div>'


def _notes(notes: Sequence[str]) -> str:
    items = "".join(f"<li>{escape(note)}</li>" for note in notes)
    return f'<ul class="notes" aria-label="Notes">{items}</ul>' if items else ""
