"""Whatever id simkit prints, `--explain` explains."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from simkit.commands.rule_book import rule_book
from simkit.diagnostics.table import GROUPS, RETIRED
from simkit.launch import rules as launch_rules

ROOT = Path(__file__).resolve().parents[3]
ID = re.compile(r"\b[A-Z]{2,5}-[EWI]\d\d\b")
TEXTS = [
    path
    for folder, pattern in (
        ("simkit", "*.py"),
        ("grader", "*.py"),
        ("docs", "*.md"),
        ("robots", "*.md"),
        ("exercises", "*.py"),
        ("exercises", "*.ipynb"),
        ("lectures", "*.md"),
        ("lectures", "*.ipynb"),
        ("solutions", "*.md"),
        ("solutions", "*.py"),
        ("solutions", "*.toml"),
    )
    for path in sorted((ROOT / folder).rglob(pattern))
] + [ROOT / "README.md"]


def test_each_id_that_is_written_anywhere_is_explained():
    known = {rule.id for rule in rule_book()}
    unknown = {
        (found, path.relative_to(ROOT).as_posix())
        for path in TEXTS
        for found in ID.findall(path.read_text("utf-8"))
        if found not in known
    }
    assert not unknown


def test_each_rule_of_launch_files_is_explained():
    ids = {
        value
        for value in vars(launch_rules).values()
        if isinstance(value, str) and ID.fullmatch(value)
    }
    assert len(ids) > 10
    assert ids <= {rule.id for rule in rule_book()}


def test_a_number_is_used_once_whatever_the_letter_and_never_again():
    numbers = [re.sub(r"-[EWI]", "-", rule.id) for rule in rule_book()]
    assert sorted(set(numbers)) == sorted(numbers)
    assert not RETIRED & set(numbers), "a retired number is not used again"


def test_each_number_is_that_of_a_rule_or_is_retired():
    used = {re.sub(r"-[EWI]", "-", rule.id) for rule in rule_book()} | RETIRED
    for group in GROUPS:
        numbers = {int(one.partition("-")[2]) for one in used if one.startswith(f"{group}-")}
        gaps = sorted(set(range(1, max(numbers) + 1)) - numbers)
        assert not gaps, (
            f"{group}: give these numbers to new rules, or list them in RETIRED: {gaps}"
        )


def test_groups_stand_together_and_numbers_rise():
    places = [(rule.id.partition("-")[0], rule.id[-2:]) for rule in rule_book()]
    groups = list(dict.fromkeys(group for group, _ in places))
    assert groups == list(GROUPS)
    for group in groups:
        numbers = [number for one, number in places if one == group]
        assert numbers == sorted(numbers)


@pytest.mark.parametrize("rule", rule_book(), ids=lambda rule: rule.id)
def test_each_row_has_an_id_a_title_and_an_explanation_with_an_example(rule):
    assert ID.fullmatch(rule.id)
    assert rule.id.partition("-")[0] in GROUPS
    assert 5 < len(rule.title) <= 90
    assert not rule.title.endswith(".")
    title, blank, *text = rule.explanation.split("\n")
    assert title.endswith(".")
    assert blank == ""
    assert len(" ".join(text)) > 150
    assert "Right" in rule.explanation
    assert re.search(r"^    \S", rule.explanation, re.MULTILINE), "an example, indented"


@pytest.mark.parametrize("name", ["LCH-E06", "lch-e06", "[LCH-E06]", "SDF-W04"])
def test_it_is_explained_on_the_command_line(simkit, name):
    code, out, err = simkit("check_urdf", "--explain", name)
    assert (code, err) == (0, "")
    assert out.startswith(f"{name.strip('[]').upper()} (")


def test_a_letter_and_a_number_may_mean_several(simkit):
    out = simkit("check_urdf", "--explain", "E08")[1]
    heads = [line.split()[0] for line in out.splitlines() if ID.match(line)]
    assert heads == ["URDF-E08", "GZ-E08", "LCH-E08"]
