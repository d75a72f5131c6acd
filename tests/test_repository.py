"""The checkout as a whole: no traces of a machine, a lock file that fits, tools that are content."""

from __future__ import annotations

import os
import re
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

from tests.laws import broken_laws

ROOT = Path(__file__).resolve().parents[1]
README = (ROOT / "README.md").read_text(encoding="utf-8")
LOCKS = {
    "requirements.lock": ("setup",),
    "requirements-test.lock": ("setup", "dev"),
}
"""Lock file, and the extras whose packages it holds beside the dependencies."""
PYPROJECT = (ROOT / "pyproject.toml").read_text(encoding="utf-8")
MAKEFILE = (ROOT / "Makefile").read_text(encoding="utf-8")
CI = ROOT / ".ci/run"

# The name of a user's folder, as machines make them, and the places where packages come from. In
# pieces, since this file is searched too.
HOMES = re.compile(rf"(?<![\w.])(?:/{'home'}/|/{'Users'}/|[A-Z]:\\{'Users'}\\)(\w+)")
REGISTRIES = re.compile(
    rf"{'py'}thonhosted|{'py'}pi\.org|(?:index(?:-url)?|find-links)[ =]+{'ht'}tp|https?://[^\s/]*"
    rf"(?:{'art'}ifact|{'nex'}us|{'reg'}istry|{'mir'}ror|{'pro'}xy)[^\s/]*/"
)
MOST_LINES = 300
LONGER = {"simkit/simulation/simulation.py": "a line for each flat name of a simulation"}
INVENTED = {"ada", "student", "me", "you", "user", "someone", "nobody", "name"}
"""Users that examples and attacks speak of; they are on no machine."""


@pytest.fixture(scope="module")
def texts() -> dict[str, str]:
    """Text by path of every file that is in git, or would be with the next `git add`."""
    command = ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"]
    try:
        listed = subprocess.run(command, cwd=ROOT, capture_output=True, check=True).stdout
    except (OSError, subprocess.CalledProcessError):
        pytest.skip("this folder is not a git checkout: which files belong to it is not known")
    paths = [ROOT / os.fsdecode(name) for name in listed.split(b"\0") if name]
    return {
        path.relative_to(ROOT).as_posix(): path.read_bytes().decode("utf-8", "replace")
        for path in paths
        if path.is_file()
    }


def pins(lock: str) -> dict[str, str]:
    """Each entry of a lock file by the name of its package."""
    entries = re.split(r"\n(?=[A-Za-z0-9])", (ROOT / lock).read_text(encoding="utf-8"))
    return {
        canonicalize_name(entry.partition("==")[0].partition("[")[0]): entry
        for entry in entries
        if not entry.startswith("#")
    }


def requirements(*extras: str) -> list[Requirement]:
    project = tomllib.loads(PYPROJECT)["project"]
    listed = [project["dependencies"], *(project["optional-dependencies"][e] for e in extras)]
    return [Requirement(text) for texts in listed for text in texts]


def run(*command: str) -> str:
    done = subprocess.run(
        [sys.executable, "-m", *command], cwd=ROOT, capture_output=True, text=True, check=False
    )
    return "" if done.returncode == 0 else done.stdout + done.stderr


# -- no traces of a machine


def test_no_file_names_a_place_on_somebodys_machine(texts: dict[str, str]) -> None:
    here = re.compile(rf"(?<![\w.]){re.escape(str(ROOT))}(?![\w-])")
    tell = len(ROOT.parts) > 2  # a checkout in /src would be found in every second sentence
    wrong = [
        f"{path}: {found[0]}"
        for path, text in texts.items()
        for found in [*HOMES.finditer(text), *(here.finditer(text) if tell else [])]
        if not (found.re is HOMES and found[1] in INVENTED)
    ]
    broken_laws(wrong, "write a path below the checkout, or a user of INVENTED in this file")


def test_no_file_names_a_registry(texts: dict[str, str]) -> None:
    found = {path: REGISTRIES.search(text) for path, text in texts.items()}
    wrong = {path: match[0] for path, match in found.items() if match}
    broken_laws(wrong, "packages come from wherever pip is configured: leave the address out")


def test_notebooks_hold_no_outputs(texts: dict[str, str]) -> None:
    notebooks = {path: text for path, text in texts.items() if path.endswith(".ipynb")}
    assert notebooks
    wrong = [path for path, text in notebooks.items() if '"output_type"' in text]
    broken_laws(wrong, "`grader build` writes notebooks without outputs; do not save over them")


# -- dependencies


@pytest.mark.parametrize("lock", [*LOCKS, "requirements-uv.lock"])
def test_each_pin_has_hashes_and_no_address(lock: str) -> None:
    assert "://" not in (ROOT / lock).read_text(encoding="utf-8")
    wrong = [
        name
        for name, entry in pins(lock).items()
        if not re.match(r"[\w.\-\[\]]+==[\w.!+]+", entry)
        or not re.search(r"--hash=sha256:[0-9a-f]{64}\b", entry)
    ]
    assert wrong == []


@pytest.mark.parametrize("lock", LOCKS)
def test_the_lock_file_fits_the_dependencies(lock: str) -> None:
    project = tomllib.loads(PYPROJECT)["project"]["name"]
    asked = {name for name, entry in pins(lock).items() if f"{project} (pyproject.toml)" in entry}
    wanted = {canonicalize_name(needed.name): needed for needed in requirements(*LOCKS[lock])}
    assert asked == set(wanted), "run make lock"
    versions = {name: pins(lock)[name].split()[0].partition("==")[2] for name in asked}
    wrong = {n: v for n, v in versions.items() if not wanted[n].specifier.contains(v, True)}
    assert wrong == {}, "run make lock"


def test_students_load_no_tools_of_developers() -> None:
    students = {needed.name for needed in requirements()}
    tools = {canonicalize_name(tool.name) for tool in requirements("dev")} - students
    tools.remove("nbclient")  # JupyterLab brings it along
    assert tools & set(pins("requirements.lock")) == set()


def test_the_tests_run_with_the_versions_that_students_have() -> None:
    def version(entry: str) -> str:
        return entry.split()[0]

    students, tests = pins("requirements.lock"), pins("requirements-test.lock")
    moved = [name for name in students if version(students[name]) != version(tests[name])]
    assert moved == [], "run make lock"
    assert version(pins("requirements-uv.lock")["uv"]) == version(students["uv"]), "run make lock"


def test_each_dependency_says_why_it_is_there() -> None:
    lines = [line for line in PYPROJECT.splitlines() if re.match(r'\s+"[\w-]+[>=<~!]', line)]
    assert len(lines) == len(requirements("setup", "dev"))
    assert [line for line in lines if not re.search(r'",\s*# \S+ \S+', line)] == []


# -- size


def test_no_module_is_longer_than_a_few_screens(texts: dict[str, str]) -> None:
    ours = re.compile(r"(simkit|grader|exercises/oracles)/.*\.py")
    lengths = {path: text.count("\n") for path, text in texts.items() if ours.fullmatch(path)}
    long = {
        path: f"{count} lines"
        for path, count in lengths.items()
        if count > MOST_LINES and path not in LONGER
    }
    broken_laws(long, f"at most {MOST_LINES} lines: which two ideas are in it? Do not pack lines")


# -- commands


def test_commands_of_the_texts_exist() -> None:
    targets = set(re.findall(r"^([\w-]+):", MAKEFILE, re.MULTILINE))
    phony = set(MAKEFILE.partition(".PHONY: ")[2].partition("\n")[0].split())
    contributing = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    named = set(re.findall(r"(?:^|`)make ([a-z][\w-]*)", README + contributing, re.MULTILINE))
    assert {"lab", "grade", "test", "bench"} <= named
    assert named <= targets & phony


def test_ci_runs_the_commands_of_readme() -> None:
    assert "`.ci/run`" in README
    assert os.access(CI, os.X_OK)
    script = CI.read_text(encoding="utf-8")
    assert "make test" in script
    assert "make lint" in script
    for name in re.findall(r"^\s*(\.ci/\w+)", script, re.MULTILINE):
        assert os.access(ROOT / name, os.X_OK)


def test_readmes_install_without_make_is_what_make_does() -> None:
    block = (
        README.partition("## Without make")[2].partition("```powershell\n")[2].partition("```")[0]
    )
    for line in block.splitlines()[2:4]:
        made = line.removeprefix("python -m pip install ")
        assert made in MAKEFILE.replace("--quiet ", "")
    assert "grader start all" in block
    assert "grader start all" in MAKEFILE


# -- tools


@pytest.mark.parametrize("command", [("ruff", "check", "."), ("ruff", "format", "--check", ".")])
def test_ruff_is_content(command: tuple[str, ...]) -> None:
    broken_laws(
        run(*command).splitlines(),
        "`make lint` shows it; `ruff check --fix` and `ruff format` mend most",
    )


@pytest.mark.slow  # and `make lint`, with which CI begins
def test_mypy_is_content() -> None:
    broken_laws(run("mypy").splitlines(), "`make lint` shows it, in a second once it has run")
