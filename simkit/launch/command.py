"""`command=` of a parameter: no shell is asked, and no program is run but xacro; what `cat` would say is worked out.

Source: roslaunch splits the command like a shell, runs it, and takes what it prints.
"""

from __future__ import annotations

import re
import shlex
from dataclasses import dataclass
from pathlib import Path, PurePosixPath

from simkit.launch.errors import Kind, LaunchRefused, Lesson
from simkit.launch.files import Files
from simkit.launch.rules import COMMAND

_XACRO_TAG = re.compile(r"<\s*xacro:|\$\{|\$\((?:arg|find|eval|env|optenv|dirname|cwd)\b")
_XACRO_OPTIONS = ("--inorder", "-i", "--inord", "-v")
_BANNER = re.compile(r"(?:<!-- [=|].*[=|] -->\n)+")
"""What xacro puts first: it has the path of the file in it, which differs from machine to machine."""
_HAND_IN = (
    "Make a URDF of it, simkit xacro FILE > robot.urdf, hand that in, and load it by textfile=."
)
_OF_SHELLS = ("|", "||", "&", "&&", ";", "<", ">", ">>", "2>&1")
UNDERSTOOD = "cat FILE, echo WORDS and xacro FILE"


@dataclass(frozen=True, slots=True, kw_only=True)
class CommandOutput:
    """What a command prints."""

    text: str
    """Its output."""
    source: Path | None = None
    """The one file that the text is from, if it is from one."""


def output_of(command: str, *, parameter: str, files: Files) -> CommandOutput:
    """What a command would print.

    Args:
        command: As in the attribute, `$(...)` replaced.
        parameter: Name of the parameter, for messages.
        files: Reads what the command names.

    Raises:
        LaunchRefused: The command fails, or is not one of those that are understood.
    """
    try:
        words = shlex.split(command)
    except ValueError as error:
        lesson = Lesson(
            rule=COMMAND, what=f"{command}: {error}", remedy="Close the quotation mark."
        )
        raise LaunchRefused(Kind.VALUE, str(error), lesson) from None
    return _Command(words, parameter, files).output()


class _Command:
    def __init__(self, words: list[str], parameter: str, files: Files) -> None:
        self._words = words
        self._parameter = parameter
        self._files = files

    def output(self) -> CommandOutput:
        program, arguments = self._program()
        if program == "cat" and not arguments:
            raise self._fails(1, "cat without a file would wait for ever", "Write cat FILE.")
        if program == "cat":
            texts = [self._file(name) for name in arguments]
            source = Path(arguments[0]) if len(arguments) == 1 else None
            return CommandOutput(text="".join(texts), source=source)
        if program == "echo":
            newline = "" if arguments[:1] == ["-n"] else "\n"
            return CommandOutput(text=" ".join(arguments[not newline :]) + newline)
        if program in ("true", "false"):
            return self._nothing(program)
        if program == "xacro":
            return self._xacro(arguments)
        raise self._not_understood(program)

    def _program(self) -> tuple[str, list[str]]:
        """Name of the program, and its arguments; `rosrun xacro xacro` is xacro."""
        words = self._words
        if words[:2] == ["rosrun", "xacro"]:
            words = words[2:]
        name = PurePosixPath(words[0].replace("\\", "/")).name if words else ""
        return name.removesuffix(".py") if name.startswith("xacro") else name, words[1:]

    def _nothing(self, program: str) -> CommandOutput:
        if program == "false":
            raise self._fails(1, "the command false always fails", "Remove it.")
        return CommandOutput(text="")

    def _xacro(self, arguments: list[str]) -> CommandOutput:
        names = [word for word in arguments if word not in _XACRO_OPTIONS and ":=" not in word]
        if len(names) != 1 or names[0].startswith("-"):
            what = f"this use of xacro is not understood: {' '.join(self._words)}"
            raise self._fails(2, what, "Write xacro FILE.")
        text = self._file(names[0])
        if not _XACRO_TAG.search(text):
            return CommandOutput(text=text, source=Path(names[0]))
        if self._files.confined:
            what = f"{self._files.shown(names[0])} has macros, and xacro is not run on what was handed in"
            raise self._fails(1, what, _HAND_IN)
        return CommandOutput(text=self._expanded(arguments))

    def _expanded(self, arguments: list[str]) -> str:
        from simkit.xacro import XacroError, run_xacro

        try:
            text = run_xacro(arguments, packages=self._files.path).text
        except XacroError as error:
            raise self._fails(error.exit_code, f"xacro: {error}", "Mend that file.") from None
        return _BANNER.sub("", text, count=1)

    def _file(self, name: str) -> str:
        if name in _OF_SHELLS:
            what = f"{name} is for a shell, and neither roslaunch nor simkit asks one"
            raise self._fails(1, what, "Name one file, and load it as it is.")
        try:
            return self._files.read_text(name)
        except LaunchRefused as refused:
            if refused.kind is Kind.OURS:
                raise
            raise self._fails(1, refused.lesson.what, refused.lesson.remedy) from None

    def _fails(self, code: int, what: str, remedy: str) -> LaunchRefused:
        words = f"command [{self._words}] returned with code [{code}]"
        return self._refused(words, what, remedy)

    def _not_understood(self, program: str) -> LaunchRefused:
        what = f"the program {program!r} is not run: simkit runs none from a launch file"
        return self._refused(
            f"no such command [{self._words}]", what, f"What is understood: {UNDERSTOOD}."
        )

    def _refused(self, words: str, what: str, remedy: str) -> LaunchRefused:
        text = f"Cannot load command parameter [{self._parameter}]: {words}"
        return LaunchRefused(Kind.VALUE, text, Lesson(rule=COMMAND, what=what, remedy=remedy))
