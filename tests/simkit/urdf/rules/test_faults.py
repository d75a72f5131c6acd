"""Files with one fault each: the rule that finds it, the place, the remedy, and no second find about the same."""

from __future__ import annotations

import tomllib
from pathlib import Path

import pytest

from simkit.diagnostics import Diagnostic, Severity
from simkit.packages import PackagePath
from simkit.urdf.rules import Companion, CompanionKind, all_rules, check_robot
from simkit.xml import parse_xml
from tests.laws import broken_laws

FAULTS = Path(__file__).parents[1] / "faults"
TABLES = sorted(FAULTS.glob("faults*.toml"))
ENTRIES = [entry for table in TABLES for entry in tomllib.loads(table.read_text("utf-8"))["fault"]]
FILES = sorted({entry["file"] for entry in ENTRIES})


@pytest.fixture(scope="module")
def packages(tmp_path_factory: pytest.TempPathFactory) -> PackagePath:
    """One package, `faults`, with a mesh."""
    folder = tmp_path_factory.mktemp("packages")
    meshes = folder / "faults" / "meshes"
    meshes.mkdir(parents=True)
    (folder / "faults" / "package.xml").write_text("<package/>")
    (meshes / "cube.stl").write_bytes((FAULTS / "meshes" / "cube.stl").read_bytes())
    return PackagePath([folder])


@pytest.fixture(scope="module")
def find(packages: PackagePath):
    """What the rules find in a text, with the companions that a table names."""

    def find(text: str, file: str, companions: tuple[str, ...] = ()) -> tuple[Diagnostic, ...]:
        beside = tuple(
            Companion(
                kind=CompanionKind("launch" if name.endswith((".launch", ".xml")) else "yaml"),
                file=name,
                text=(FAULTS / name).read_text("utf-8"),
            )
            for name in companions
        )
        document = parse_xml(text, file=file)
        return check_robot(document, packages=packages, companions=beside, folder=FAULTS)

    return find


def entries_of(file: str) -> list[dict]:
    return [entry for entry in ENTRIES if entry["file"] == file]


def companions_of(file: str) -> tuple[str, ...]:
    return tuple(entries_of(file)[0].get("companions", ()))


@pytest.mark.parametrize("file", FILES)
def test_the_fault_is_found_once_at_its_place_with_a_remedy(file, find):
    found = find((FAULTS / file).read_text("utf-8"), file, companions_of(file))
    listed = {(one.rule, one.severity.value, one.span.line, one.span.column): one for one in found}
    expected = [(entry["rule"], entry["severity"], *entry["at"]) for entry in entries_of(file)]
    assert set(expected) <= set(listed), [str(one) for one in listed]
    for key, entry in zip(expected, entries_of(file), strict=True):
        assert [word for word in entry["remedy"] if word not in listed[key].remedy] == []
    worse = [key for key in listed if key[1] != "note"]
    assert [key for key in worse if key not in expected] == []


@pytest.mark.parametrize("file", [name for name in FILES if "mend" in entries_of(name)[0]])
def test_the_mended_file_is_clean(file, find):
    text = (FAULTS / file).read_text("utf-8")
    rules = {entry["rule"] for entry in entries_of(file)}
    for entry in entries_of(file):
        for wrong, right in entry["mend"]:
            assert wrong in text
            text = text.replace(wrong, right)
    found = find(text, file, companions_of(file))
    assert [one for one in found if one.severity is not Severity.NOTE or one.rule in rules] == []


def test_the_unfaulty_original_of_the_planted_files_is_clean(find):
    text = (FAULTS / "planted/00_clean.urdf").read_text("utf-8")
    assert [one for one in find(text, "x.urdf") if one.severity is not Severity.NOTE] == []


def test_each_rule_finds_a_planted_fault():
    found = {entry["rule"] for entry in ENTRIES}
    lacking = [
        f'no [[fault]] with rule = "{rule.id}" in faults*.toml: add a file with that one fault, its place and words of its remedy'
        for rule in all_rules()
        if rule.id not in found
    ]
    assert not lacking, "\n".join(lacking)


def test_each_file_belongs_to_a_table():
    there = {path.relative_to(FAULTS).as_posix() for path in FAULTS.rglob("*.urdf")}
    apart = {"planted/00_clean.urdf", "two_wheels_many_faults.urdf"}
    broken_laws(
        sorted(there - set(FILES) - apart),
        "give the file a [[fault]] in one of faults*.toml: the rule that finds it, and where",
    )
