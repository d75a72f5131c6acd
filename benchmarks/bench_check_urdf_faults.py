"""Who names a planted fault: simkit check_urdf, next to ten other tools that read URDF.

The answers of the other tools were recorded once, each planted into a robot like this one; they are data here. Only urdfdom's
own check_urdf is run again, where it is installed.
"""

from __future__ import annotations

import shutil
import subprocess
import tempfile
from pathlib import Path

from figures import Figure, show

from simkit.diagnostics import Diagnostic, Severity
from simkit.packages import PackagePath
from simkit.urdf.rules import check_robot
from simkit.xml import parse_xml

PLANTED = Path(__file__).parents[1] / "tests/simkit/urdf/faults/planted"
TOOLS = {
    "urdfdom": "urdfdom, of which check_urdf and dartpy are made",
    "yourdfpy": "yourdfpy",
    "pytr3d": "pytransform3d",
    "urdf_py": "urdf_parser_py",
    "rtb": "roboticstoolbox-python",
    "mujoco": "mujoco",
    "drake": "drake",
    "pinocchio": "pinocchio",
    "pybullet": "pybullet",
    "validator": "urdf-validator",
}
LEGEND = "L names the place, N the culprit, v is vague, . says nothing, X crashes or hangs"
RECORDED = {
    "01": "L . . L L L v v L v",
    "02": "L . . L L L v v L v",
    "03": "N X N . . v N v v N",
    "04": "N v . . N . . v v .",
    "05": "N . . . . v . v X N",
    "06": ". . . N . . . . . N",
    "07": ". . . . . N . . . N",
    "08": ". . . . . N . . . N",
    "09": "v . . . N . . . v .",
    "10": "v v v N N L N v . v",
    "11": ". . . . . . . . . .",
    "12": ". . . . . . X . . N",
    "13": ". . . . . . . . . .",
    "14": "N X v . N v N v v N",
    "15": ". . . . . . . . . N",
    "16": "v N N N N L L v v v",
    "17": ". . . . . . . . . .",
    "18": "N . . . . v N v v X",
    "20": ". . . . . . . . . N",
    "21": ". . . . . N L . . .",
    "22": ". . . . . . . . . .",
    "23": ". . . . . . . . . .",
}
"""What each tool answered, in the order of `TOOLS`."""
LONGEST_SECONDS = 10.0


def ours(path: Path, packages: PackagePath) -> Diagnostic | None:
    """What we find, if it is one error or warning."""
    found = check_robot(parse_xml(path.read_bytes(), file=path.name), packages=packages)
    worse = [one for one in found if one.severity is not Severity.NOTE]
    return worse[0] if len(worse) == 1 else None


def urdfdom_here(program: str | None, path: Path) -> str:
    """What the check_urdf of this machine does with a file."""
    if program is None:
        return "-"
    done = subprocess.run(
        [program, path], capture_output=True, check=False, timeout=LONGEST_SECONDS
    )
    if done.returncode:
        return "refuses"
    return "complains" if done.stderr else "accepts"


def rows(packages: PackagePath) -> list[tuple[str, Diagnostic | None, str]]:
    """Each fault by its file name, with our answer and urdfdom's."""
    program = shutil.which("check_urdf")
    files = [path for path in sorted(PLANTED.glob("*.urdf")) if path.stem[:2] in RECORDED]
    return [(path.stem, ours(path, packages), urdfdom_here(program, path)) for path in files]


def count_line(title: str, mark: str, own: int) -> str:
    """How often each tool got a mark."""
    columns = zip(*(marks.split() for marks in RECORDED.values()), strict=True)
    counts = "".join(f"{column.count(mark):>10}" for column in columns)
    return f"{title:<28}{own:<24}{'':<10}{counts}"


def main() -> None:
    """Print the table and the figure."""
    with tempfile.TemporaryDirectory() as empty:
        found = rows(PackagePath([empty], confined=True))
    head = "".join(f"{tool:>10}" for tool in TOOLS)
    print(f"{'fault':<28}{'simkit check_urdf':<24}{'here':<10}{head}")
    for name, one, live in found:
        answer = "." if one is None else f"{one.rule} {one.span.line}:{one.span.column}"
        others = "".join(f"{mark:>10}" for mark in RECORDED[name[:2]].split())
        print(f"{name:<28}{answer:<24}{live:<10}{others}")
    print(
        count_line(f"says nothing, of {len(found)}", ".", sum(one is None for _, one, _ in found))
    )
    print(count_line("crashes or hangs", "X", 0))
    print(f"{LEGEND}; here: what the check_urdf of this machine does")
    print("; ".join(f"{short}: {name}" for short, name in TOOLS.items() if short != name))
    print()
    for name, one, _ in found:
        if one is not None:
            print(f"{name}: {one.what}\n    {one.remedy}")
    named = sum(one is not None and bool(one.remedy) for _, one, _ in found)
    show(Figure("planted URDF faults named", named, "of 22", 22, more_is_better=True))


if __name__ == "__main__":
    main()
