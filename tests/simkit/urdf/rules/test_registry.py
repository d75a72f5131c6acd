"""Laws that hold for every rule; those on ids and explanations are in tests/simkit/cli/test_rule_book.py."""

from __future__ import annotations

import tomllib
from pathlib import Path

from simkit.diagnostics import Severity
from simkit.urdf.rules import all_rules
from simkit.urdf.rules.check import rules_for
from simkit.urdf.rules.sheet import read_sheet
from simkit.xml import parse_xml

FILES = sorted((Path(__file__).parents[1]).rglob("*.urdf"))
WORST = {Severity.ERROR: 0, Severity.WARNING: 1, Severity.NOTE: 2}


def test_no_rule_reports_worse_than_it_says():
    says = {rule.id: rule.severity for rule in all_rules()}
    for table in sorted((Path(__file__).parents[1] / "faults").glob("faults*.toml")):
        for entry in tomllib.loads(table.read_text("utf-8"))["fault"]:
            assert WORST[Severity(entry["severity"])] >= WORST[says[entry["rule"]]], entry


def test_rules_that_are_not_asked_have_nothing_to_say():
    for path in FILES:
        sheet = read_sheet(parse_xml(path.read_bytes(), file=path.name))
        asked = {rule.id for rule in rules_for(sheet)}
        rest = [rule for rule in all_rules() if rule.id not in asked]
        assert [find for rule in rest for find in rule.look(sheet)] == [], path.name
