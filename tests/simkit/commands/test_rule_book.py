"""Whatever id simkit prints, `--explain` explains."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from simkit.commands.rule_book import rule_book
from simkit.launch import rules as launch_rules

ROOT = Path(__file__).resolve().parents[3]
ID = re.compile(r"\b[A-Z]{2,5}-[EWI]\d\d\b")
MET = [rule for rule in rule_book() if rule.look is None]
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


def test_a_number_is_used_once_whatever_the_letter():
    numbers = [re.sub(r"-[EWI]", "-", rule.id) for rule in rule_book()]
    assert sorted(set(numbers)) == sorted(numbers)


def test_groups_stand_together_and_numbers_rise():
    places = [(rule.id.partition("-")[0], rule.id[-2:]) for rule in rule_book()]
    groups = list(dict.fromkeys(group for group, _ in places))
    assert groups == ["URDF", "GZ", "CTL", "LCH", "LAS", "SDF"]
    for group in groups:
        numbers = [number for one, number in places if one == group]
        assert numbers == sorted(numbers)


@pytest.mark.parametrize("rule", MET, ids=lambda rule: rule.id)
def test_a_rule_that_is_met_has_the_form_of_the_others(rule):
    assert 5 < len(rule.title) <= 90
    title, blank, *text = rule.explanation.split("\n")
    assert title.endswith(".")
    assert blank == ""
    for word in ("Symptom: ", "Cause: ", "Remedy: ", "Right:"):
        assert any(line.startswith(word) for line in text), word
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
