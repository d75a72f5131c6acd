"""`$(find pkg)`, `$(arg x)` and their kin in the values of attributes.

Source: roslaunch `substitution_args`: first `env`, `optenv`, `dirname`, `anon` and `arg` are replaced, then `find` in what came
out; a value that is `$(eval ...)` as a whole is an expression. `$(find pkg` without its bracket stays as it is.
"""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from simkit.errors import near_names
from simkit.launch.errors import Kind, LaunchRefused, Lesson
from simkit.launch.expression import evaluate_expression
from simkit.launch.files import Budget, Files
from simkit.launch.rules import SUBSTITUTION
from simkit.launch.scope import Scope
from simkit.launch.values import convert

COMMANDS = ("find", "env", "optenv", "dirname", "anon", "arg")
_FIRST = COMMANDS[1:]
_CLOSED = re.compile(r"\$\(([^()$]+)\)")
_FAULTY = re.compile(r"\$\([^()$]*([$(])")
_TOO_FEW = {
    "arg": "$(arg var) must specify an environment variable",
    "anon": "$(anon var) must specify a name",
    "env": "$(env var) command only accepts one argument",
    "find": "$(find pkg) command only accepts one argument",
    "optenv": "$(optenv var) must specify an environment variable",
}
_TOO_MANY = {
    "arg": "$(arg var) may only specify one arg",
    "anon": "$(anon var) may only specify one name",
    "env": _TOO_FEW["env"],
    "find": _TOO_FEW["find"],
}


@dataclass(frozen=True, slots=True, kw_only=True)
class Substitution:
    """Replaces `$(...)` in texts."""

    files: Files
    """Finds packages."""
    budget: Budget
    """Counts the characters that come out."""
    environment: Mapping[str, str]
    """What `$(env X)` sees."""
    anonymous: Callable[[str], str]
    """Makes a name that nobody else has, from an id."""

    def resolve(self, text: str, scope: Scope) -> str:
        """A text with every `$(...)` replaced.

        Raises:
            LaunchRefused: One cannot be.
        """
        if "$" not in text:
            return text
        if text.startswith("$(eval ") and text.endswith(")"):
            resolved = self._evaluated(text[len("$(eval ") : -1], scope)
        else:
            resolved = self._replaced(self._replaced(text, scope, _FIRST), scope, ("find",))
        self.budget.string(len(resolved))
        return resolved

    def _replaced(self, text: str, scope: Scope, commands: tuple[str, ...]) -> str:
        for content in _contents(text):
            command, *words = [word for word in content.split(" ") if word] or [""]
            if command not in COMMANDS:
                raise _unknown(content, command)
            if command not in commands:
                continue
            _require_words(command, words, content)
            if command == "find":
                text = self._with_package(text, content, words[0])
            else:
                text = text.replace(f"$({content})", self._value(command, words, scope))
            self.budget.string(len(text))
        return text

    def _value(self, command: str, words: list[str], scope: Scope) -> str:
        if command == "dirname":
            return str(self.dirname(scope))
        if command == "env":
            return self.env(words[0])
        if command == "optenv":
            return self.optenv(words[0], " ".join(words[1:]))
        return self.arg(words[0], scope) if command == "arg" else self.anon(words[0], scope)

    def _with_package(self, text: str, content: str, package: str) -> str:
        """A text with one `$(find pkg)` replaced; what follows up to a blank is a path in the package."""
        before, _, after = text.partition(f"$({content})")
        path, blank, rest = after.partition(" ")
        folder = str(self.find(package))
        path = path.replace("\\", "/").replace("/", os.sep)
        inside = path[1:] if path[:1] == os.sep else path
        return before + (f"{folder}{os.sep}{inside}" if path else folder) + blank + rest

    # -- the commands, which are functions in $(eval ...) too

    def arg(self, name: str, scope: Scope) -> str:
        """The value of an argument."""
        if name in scope.arguments:
            return scope.arguments[name]
        raise LaunchRefused(Kind.ARGUMENT, name, _no_argument(name, scope))

    def anon(self, identity: str, scope: Scope) -> str:
        """A name that nobody else has: the same one for each use of the id in one file."""
        if identity not in scope.anonymous:
            scope.anonymous[identity] = self.anonymous(identity)
        return scope.anonymous[identity]

    def env(self, name: str) -> str:
        """The value of an environment variable."""
        if name in self.environment:
            return self.environment[name]
        what = f"there is no environment variable {name!r}"
        remedy = f"Write $(optenv {name} DEFAULT), or better an <arg> with a default."
        lesson = Lesson(rule=SUBSTITUTION, what=what, remedy=remedy)
        raise LaunchRefused(Kind.SUBSTITUTION, f"environment variable '{name}' is not set", lesson)

    def optenv(self, name: str, default: str = "") -> str:
        """The value of an environment variable, or a default."""
        return self.environment.get(name, default)

    def dirname(self, scope: Scope) -> Path:
        """Folder of the launch file."""
        return Path(scope.launch_file.name).absolute().parent

    def find(self, package: str) -> Path:
        """Folder of a package."""
        return self.files.find_package(package)

    def _evaluated(self, expression: str, scope: Scope) -> str:
        def argument(name: str) -> Any:
            return convert(scope.arguments[name], "auto")

        functions: dict[str, Callable[..., Any]] = {
            "arg": lambda name: convert(self.arg(str(name), scope), "auto"),
            "anon": lambda name: self.anon(str(name), scope),
            "env": lambda name: self.env(str(name)),
            "optenv": lambda name, default="": self.optenv(str(name), str(default)),
            "find": lambda package: str(self.find(str(package))),
            "dirname": lambda: str(self.dirname(scope)),
        }
        return evaluate_expression(expression, arguments=argument, functions=functions)


def _contents(text: str) -> list[str]:
    """What stands in each `$(...)`, in order."""
    faulty = _FAULTY.search(text)
    if faulty is not None:
        words = f"Invalid left parenthesis '(' in substitution args [{text}]"
        if faulty[1] == "$":
            words = f"Dollar signs '$' cannot be inside of substitution args [{text}]"
        what = "$(...) cannot stand inside of $(...)"
        remedy = "Put the inner one into an <arg> of its own, or write one $(eval ...)."
        raise LaunchRefused(
            Kind.SUBSTITUTION, words, Lesson(rule=SUBSTITUTION, what=what, remedy=remedy)
        )
    return [match[1] for match in _CLOSED.finditer(text)]


def _unknown(content: str, command: str) -> LaunchRefused:
    words = f"Unknown substitution command [{content}]. Valid commands are {list(COMMANDS)}"
    what = f"there is no $({command} ...)"
    remedy = f"Write one of {', '.join(COMMANDS)}, or $(eval ...) as the whole value."
    if near := near_names(command, COMMANDS):
        remedy = f"Did you mean $({near[0]} ...)?"
    if command == "eval":
        what = "$(eval ...) must be the whole value"
        remedy = "Write the texts around it into the expression: $(eval 'a' + arg('b'))."
    return LaunchRefused(
        Kind.SUBSTITUTION, words, Lesson(rule=SUBSTITUTION, what=what, remedy=remedy)
    )


def _no_argument(name: str, scope: Scope) -> Lesson:
    if name in scope.declared:
        what = f"the argument {name!r} has no value"
        remedy = f"Give it one: {_how_to_give(name, scope)}, or default= in its <arg>."
        strays = [given for given in scope.arguments if given not in scope.declared]
        if near := near_names(name, strays):
            remedy = f"Write {name!r} where {near[0]!r} is given, which nobody declares."
    else:
        what = f"there is no argument {name!r} here"
        remedy = f'Declare it above: <arg name="{name}" default="..."/>.'
        if near := near_names(name, scope.arguments):
            remedy = f"Did you mean $(arg {near[0]})?"
    return Lesson(rule=SUBSTITUTION, what=what, remedy=remedy)


def _how_to_give(name: str, scope: Scope) -> str:
    """How whoever uses the file gives its argument a value."""
    if scope.launch_file.included_at is None:
        return f"{name}:=... on the command line"
    return f'<arg name="{name}" value="..."/> in the <include>'


def _require_words(command: str, words: list[str], content: str) -> None:
    fault = "" if len(words) == 1 else (_TOO_MANY if words else _TOO_FEW).get(command, "")
    if fault:
        lesson = Lesson(
            rule=SUBSTITUTION,
            what=f"$({content}) has {len(words)} words behind {command}",
            remedy="Write $(find PACKAGE), $(arg NAME), $(env NAME), $(anon ID), $(optenv NAME DEFAULT).",
        )
        raise LaunchRefused(Kind.SUBSTITUTION, f"{fault} [{content}]", lesson)
