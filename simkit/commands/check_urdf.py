"""`simkit check_urdf`: what ROS makes of a URDF, and what is wrong with it.

Source: check_urdf of urdfdom: standard output, and the exit code.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace

from simkit.commands.command import Answer, ErrorText, parsed
from simkit.commands.errors import FAILURE, ToolError
from simkit.commands.robot_file import RobotFile, read_file
from simkit.diagnostics import Diagnostic, Layout, Severity, as_json, as_text, count_text
from simkit.errors import SimkitError
from simkit.urdf import check_urdf_text, read_robot
from simkit.urdf.rules import Companion, CompanionKind, check_robot

_PROGRAM = "simkit check_urdf"
REFUSED = 255
"""Exit code of the original for a file that it refuses, and for one that it cannot open."""
_KINDS = {
    ".launch": CompanionKind.LAUNCH,
    ".yaml": CompanionKind.YAML,
    ".yml": CompanionKind.YAML,
}
_ALONE = "; {0} is checked beside a URDF: simkit check_urdf ROBOT.urdf {0}"
_EPILOG = """\
Standard output and exit code are those of ROS's check_urdf: 0 if it accepts the file, 255 if not. What is wrong, where, what
follows from it and what would be right stands on standard error. FILE may be package://PACKAGE/urdf/NAME.urdf, or - for
standard input; launch and YAML files among them are checked together with the URDFs.
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Files, and how to look at them."""
    parser.epilog = _EPILOG
    parser.add_argument(
        "files", metavar="FILE", nargs="*", help="a URDF file; several are checked one by one"
    )
    parser.add_argument(
        "--strict",
        action="store_true",
        help="exit code 1 if there are errors or warnings, though ROS accepts the file",
    )
    parser.add_argument(
        "--format",
        choices=("text", "json"),
        default="text",
        help="json: all finds on standard output, and nothing else",
    )
    parser.add_argument("--notes", action="store_true", help="show notes whole, not in a line each")
    parser.add_argument(
        "--launch",
        metavar="FILE",
        action="append",
        default=[],
        help="a launch file that must fit the URDF",
    )
    parser.add_argument(
        "--yaml",
        metavar="FILE",
        action="append",
        default=[],
        help="a file of controllers that must fit it",
    )
    parser.add_argument("--explain", metavar="ID", help="explain a rule, e.g. URDF-W07")
    parser.add_argument("--list-rules", action="store_true", help="list all rules")


def _answer(arguments: argparse.Namespace) -> Answer:
    """Check the files, or tell of the rules."""
    if arguments.list_rules or arguments.explain is not None:
        from simkit.commands import (
            rule_book,  # with launch files and worlds: more than a robot needs
        )

        listed = arguments.list_rules
        yield (
            rule_book.rules_text() if listed else rule_book.explanation_of(arguments.explain)
        ) + "\n"
        return 0
    urdfs = [name for name in arguments.files if _kind(name) is None]
    if not urdfs:
        more = _ALONE.format(arguments.files[0]) if arguments.files else ""
        raise ToolError(f"Expect URDF xml file to parse{more}", exit_code=REFUSED)
    try:
        companions = tuple(_companions(arguments))
    except SimkitError as error:
        raise ToolError(str(error), exit_code=REFUSED) from error
    checks = [_Check(name, companions, arguments) for name in urdfs]
    for check in checks:
        yield from check.texts(heading=len(checks) > 1)
    if arguments.format == "json":
        yield as_json([one for check in checks for one in check.diagnostics]) + "\n"
    return max(check.code for check in checks)


class _Check:
    """One file, read and looked at."""

    def __init__(
        self, name: str, companions: Sequence[Companion], arguments: argparse.Namespace
    ) -> None:
        self._name = name
        self._is_text = arguments.format == "text"
        self._shows_notes = bool(arguments.notes)
        self.diagnostics: tuple[Diagnostic, ...] = ()
        self.code = 0
        self._out = self._err = self._complaint = ""
        try:
            self._look(read_file(name), companions)
        except SimkitError as error:
            self._complaint, self.code = str(error), REFUSED
        is_worse = _is_worse_than_notes(self.diagnostics)
        if arguments.strict and is_worse and self.code == 0:
            self.code = FAILURE

    def _look(self, file: RobotFile, companions: Sequence[Companion]) -> None:
        reading = read_robot(file.data, file=file.name, packages=file.packages, folder=file.folder)
        self._out, self._err, self.code = check_urdf_text(reading)
        self.diagnostics = check_robot(
            reading.document, packages=file.packages, companions=companions, folder=file.folder
        )

    def texts(self, *, heading: bool) -> Iterator[str]:
        """What ROS says of it, and what we find."""
        head = f"== {self._name}\n" if heading else ""
        if self._is_text:
            yield head + self._out
            found = _text(self.diagnostics, whole=self._shows_notes)
            yield ErrorText((head if self._err or found else "") + self._err + found)
        if self._complaint:
            yield ErrorText(f"{_PROGRAM}: {' '.join(self._complaint.split())}\n")


def _is_worse_than_notes(diagnostics: Sequence[Diagnostic]) -> bool:
    return any(one.severity is not Severity.NOTE for one in diagnostics)


def _text(diagnostics: Sequence[Diagnostic], *, whole: bool) -> str:
    """Errors and warnings, then the notes, whole too or with their head only; then how many there are."""
    if not diagnostics:
        return ""
    notes = [one for one in diagnostics if one.severity is Severity.NOTE and not whole]
    shown = [one for one in diagnostics if whole or one.severity is not Severity.NOTE]
    more = " (--notes tells more)" if notes else ""
    layout = Layout.of(sys.stderr)
    parts = [as_text(shown, layout=layout)] if shown else []
    if notes:
        parts.append("".join(as_text([_head(one)], layout=layout) for one in notes))
    return "\n".join(parts) + f"{count_text(diagnostics)}{more}\n"


def _head(one: Diagnostic) -> Diagnostic:
    return replace(one, path="", here="", gazebo="", remedy="", source="", related=())


def _kind(name: str) -> CompanionKind | None:
    return next((kind for suffix, kind in _KINDS.items() if name.endswith(suffix)), None)


def _companions(arguments: argparse.Namespace) -> Iterable[Companion]:
    named = [(name, kind) for name in arguments.files if (kind := _kind(name)) is not None]
    named += [(name, CompanionKind.LAUNCH) for name in arguments.launch]
    named += [(name, CompanionKind.YAML) for name in arguments.yaml]
    for name, kind in named:
        file = read_file(name)
        yield Companion(kind=kind, file=file.name, text=file.data.decode("utf-8", "replace"))


run = parsed("check_urdf", add_arguments, _answer)
