"""`grader ...`: grade a class, and make and verify the exercises.

Exit codes: 0 when all is as it should be and every submission got a verdict, 1 when `build
--check`, `verify` or `check` found something, 2 for a wrong call or a fault of ours, 130 when
stopped by Ctrl-C.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TypeAlias

from grader import commands
from grader.errors import GraderError
from simkit.errors import SimkitError

FAULT = 2
INTERRUPTED = 130


def main(arguments: Sequence[str] | None = None) -> int:
    """Run a command line; what to tell people is printed, errors as one line.

    Args:
        arguments: Words behind `grader`; those of this process if None.

    Returns:
        The exit code.
    """
    options = parser().parse_args(arguments)
    try:
        return int(options.run(options))
    except (GraderError, SimkitError, OSError) as error:
        print(f"grader: {error}", file=sys.stderr)
        return FAULT
    except KeyboardInterrupt:
        print("grader: stopped; what was graded is kept, --resume goes on", file=sys.stderr)
        return INTERRUPTED


def parser() -> argparse.ArgumentParser:
    """The command line of `grader`."""
    top = argparse.ArgumentParser(prog="grader", description="Grade and make exercises.")
    top.add_argument(
        "--root", type=Path, help="folder of the workbook (default: the nearest with exercises/)"
    )
    commands_of = top.add_subparsers(metavar="COMMAND", required=True)
    _add_grade(commands_of)
    _add_check(commands_of)
    _add_authoring(commands_of)
    return top


_Commands: TypeAlias = "argparse._SubParsersAction[argparse.ArgumentParser]"


def _add_grade(commands_of: _Commands) -> None:
    grade = commands_of.add_parser("grade", help="grade submissions, write a gradebook")
    grade.set_defaults(run=commands.grade)
    grade.add_argument(
        "paths", nargs="+", type=Path, metavar="PATH", help="notebook, folder or zip file"
    )
    grade.add_argument(
        "--out", type=Path, default=Path("gradebook"), help="folder for the gradebook (gradebook/)"
    )
    grade.add_argument("--jobs", type=_jobs, help="how many at once (default: one per core)")
    grade.add_argument(
        "--resume", action="store_true", help="keep what an earlier run has graded already"
    )
    grade.add_argument("--only", metavar="ID", help="this exercise only, e.g. 3.1")
    grade.add_argument("--student", metavar="NAME", help="this student only")
    grade.add_argument(
        "--require-sandbox", action="store_true", help="refuse to grade without a sandbox"
    )
    grade.add_argument("--no-hidden", action="store_true", help="run the public checks only")


def _add_check(commands_of: _Commands) -> None:
    check = commands_of.add_parser("check", help="run the public checks on your work")
    check.set_defaults(run=commands.check)
    check.add_argument("id", metavar="ID", help="exercise, e.g. 3.1")


def _add_authoring(commands_of: _Commands) -> None:
    build = commands_of.add_parser("build", help="build the notebooks from their sources")
    build.set_defaults(run=commands.build)
    build.add_argument(
        "--check", action="store_true", help="write nothing; say which notebooks are stale"
    )
    start = commands_of.add_parser("start", help="copy an exercise to work/, for a student")
    start.set_defaults(run=commands.start)
    start.add_argument("id", metavar="ID", help="exercise, e.g. 3.1, or all")
    new = commands_of.add_parser("new", help="begin a new exercise")
    new.set_defaults(run=commands.new)
    new.add_argument("id", metavar="ID", help="its number, e.g. 3.11")
    new.add_argument("--title", required=True, help='its title, e.g. "Broadcast a tf"')
    new.add_argument(
        "--like", metavar="ID", help="begin as a copy of this exercise, e.g. 3.1 or S.1"
    )
    verify = commands_of.add_parser("verify", help="verify that solutions pass and stubs do not")
    verify.set_defaults(run=commands.verify)
    verify.add_argument("--jobs", type=_jobs, help="how many at once (default: one per core)")
    verify.add_argument("--only", metavar="ID", help="this exercise only, e.g. 3.1")


def _jobs(text: str) -> int:
    if not text.isdecimal() or int(text) < 1:
        raise argparse.ArgumentTypeError(f"{text!r} is not a number from 1 up")
    return int(text)


if __name__ == "__main__":
    sys.exit(main())
