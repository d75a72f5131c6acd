"""Laws that hold for every rule."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path

import pytest

from simkit.diagnostics import Rule, Severity
from simkit.urdf.rules import all_rules
from simkit.urdf.rules.check import rules_for
from simkit.urdf.rules.sheet import read_sheet
from simkit.xml import parse_xml

FILES = sorted((Path(__file__).parents[1]).rglob("*.urdf"))
WORST = {Severity.ERROR: 0, Severity.WARNING: 1, Severity.NOTE: 2}


@pytest.fixture(params=all_rules(), ids=lambda rule: rule.id)
def rule(request: pytest.FixtureRequest) -> Rule:
    found: Rule = request.param
    return found


def test_ids_are_unique_and_in_order():
    ids = [rule.id for rule in all_rules()]
    assert len(set(ids)) == len(ids)
    numbers = [re.sub(r"[EWI]", "", one) for one in ids]
    assert len(set(numbers)) == len(numbers), "a number is used once, whatever the letter"
    groups = [one.partition("-")[0] for one in ids]
    assert groups == sorted(groups, key=["URDF", "GZ", "CTL", "LCH", "LAS"].index)


def test_the_id_has_its_form(rule):
    assert re.fullmatch(r"(URDF|GZ|CTL|LCH|LAS)-[EWI]\d\d", rule.id)


def test_the_title_is_short_and_says_what_is_wrong(rule):
    assert 5 < len(rule.title) <= 90
    assert not rule.title.endswith(".")


def test_the_explanation_has_a_title_a_text_and_an_example(rule):
    title, blank, *text = rule.explanation.split("\n")
    assert title.endswith(".")
    assert blank == ""
    assert len(" ".join(text)) > 150
    assert "Right" in rule.explanation
    assert re.search(r"^    \S", rule.explanation, re.MULTILINE), "an example, indented"


def test_no_rule_reports_worse_than_it_says():
    says = {rule.id: rule.severity for rule in all_rules()}
    for table in sorted((Path(__file__).parents[1] / "faults").glob("faults*.toml")):
        for entry in tomllib.loads(table.read_text("utf-8"))["fault"]:
            assert WORST[Severity(entry["severity"])] >= WORST[says[entry["rule"]]], entry


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_rules_that_are_not_asked_have_nothing_to_say(path):
    sheet = read_sheet(parse_xml(path.read_bytes(), file=path.name))
    asked = {rule.id for rule in rules_for(sheet)}
    rest = [rule for rule in all_rules() if rule.id not in asked]
    assert [find for rule in rest for find in rule.look(sheet)] == []
