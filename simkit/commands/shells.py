"""How a shell learns the words of ROS: its PATH, `roscd`, which changes its folder, and what Tab completes."""

from __future__ import annotations

import os
import shlex
import shutil
import sys
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from simkit.commands.words import all_words
from simkit.live.session import own_folder
from simkit.packages import PATH_VARIABLES, PackagePath

PACKAGES = PATH_VARIABLES[0]
WORKSPACE = "SIMKIT_WORKSPACE"
"""Variable of the environment with the folder in which a shell was given the words: `roscd` alone goes there."""
_WINDOWS = os.name == "nt"
_ROSCD = """\
roscd() { simkit_folder="$(command simkit roscd "$@")" && cd "$simkit_folder"; }
"""
_BASH = """\
_simkit_complete() {
  local IFS=$'\\n'
  COMPREPLY=($(command simkit complete -- "${COMP_WORDS[@]:0:COMP_CWORD+1}" 2>/dev/null))
}
complete -o default -F _simkit_complete @WORDS@
"""
_ZSH = """\
_simkit_complete() {
  local -a found=("${(@f)$(command simkit complete -- "${(@)words[1,CURRENT]}" 2>/dev/null)}")
  if [[ -n "$found" ]]; then compadd -- "${found[@]}"; else _files; fi
}
(( $+functions[compdef] )) || { autoload -Uz compinit && compinit -u; }
compdef _simkit_complete @WORDS@
"""
_FISH = """\
function roscd; set -l folder (command simkit roscd $argv); and cd $folder; end
for word in @WORDS@
  complete -c $word -a '(command simkit complete -- (commandline -opc) (commandline -ct) 2>/dev/null)'
end
"""
_POWERSHELL = """\
function global:roscd { $folder = simkit.cmd roscd @args; if ($LASTEXITCODE -eq 0) { Set-Location $folder } }
Register-ArgumentCompleter -Native -CommandName ('@WORDS@' -split ' ') -ScriptBlock {
  param($word, $line, $at)
  $typed = @($line.CommandElements | ForEach-Object { $_.ToString() })
  if ($word -eq '') { $typed += '' }
  simkit.cmd complete -- @typed
}
"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Shell:
    """One kind of shell."""

    assignment: Callable[[str, str], str]
    """The line that gives a variable of the environment a value."""
    begin: str
    """Defines `roscd` and what Tab completes; `@WORDS@` are the words of ROS."""
    end: str
    """Takes it back."""
    options: Sequence[str] = ("-i",)
    """Options of a shell for a person; `@FOLDER@` has the settings, `@ENV@` prints what `begin` is part of."""
    settings: Mapping[str, str] = field(default_factory=dict)
    """Files of settings, by name."""
    environment: Mapping[str, str] = field(default_factory=dict)
    """Variables that lead to the settings."""


def _posix_assignment(name: str, value: str) -> str:
    return f"export {name}={shlex.quote(value)}\n"


def _fish_assignment(name: str, value: str) -> str:
    return f"set -gx {name} {shlex.quote(value)}\n"


def _powershell_assignment(name: str, value: str) -> str:
    quoted = value.replace("'", "''")
    return f"$env:{name} = '{quoted}'\n"


_EVAL = 'PS1="(simkit) $PS1"\neval "$(@ENV@)"\n'
SHELLS: Mapping[str, Shell] = {
    "sh": Shell(
        assignment=_posix_assignment,
        begin=_ROSCD,
        end="unset -f roscd\n",
        settings={"shrc": _EVAL},
        environment={"ENV": "@FOLDER@/shrc"},
    ),
    "bash": Shell(
        assignment=_posix_assignment,
        begin=_ROSCD + _BASH,
        end="complete -r @WORDS@ 2>/dev/null\nunset -f roscd _simkit_complete\n",
        options=("--rcfile", "@FOLDER@/bashrc", "-i"),
        settings={"bashrc": f"[ -f ~/.bashrc ] && . ~/.bashrc\n{_EVAL}"},
    ),
    "zsh": Shell(
        assignment=_posix_assignment,
        begin=_ROSCD + _ZSH,
        end="compdef -d @WORDS@ 2>/dev/null\nunset -f roscd _simkit_complete\n",
        settings={
            ".zshenv": '[ -f "$HOME/.zshenv" ] && . "$HOME/.zshenv"\n',
            ".zshrc": f'ZDOTDIR="$HOME"\n[ -f "$HOME/.zshrc" ] && . "$HOME/.zshrc"\n{_EVAL}',
        },
        environment={"ZDOTDIR": "@FOLDER@"},
    ),
    "fish": Shell(
        assignment=_fish_assignment,
        begin=_FISH,
        end="functions -e roscd\nfor word in @WORDS@; complete -c $word -e; end\n",
        options=("-C", "@ENV@ | source"),
    ),
    "powershell": Shell(
        assignment=_powershell_assignment,
        begin=_POWERSHELL,
        end="Remove-Item function:roscd\n",
        options=("-NoExit", "-Command", "& @ENV@ | Out-String | Invoke-Expression"),
    ),
}
"""The shells by name."""
_KIN = {"ash": "sh", "busybox": "sh", "dash": "sh", "ksh": "sh", "mksh": "sh", "pwsh": "powershell"}


def shell_of_parent() -> str:
    """Name of the shell that runs this process; the user's usual one where that cannot be seen."""
    try:
        parent = Path(f"/proc/{os.getppid()}/comm").read_text().strip()
    except OSError:
        parent = ""
    usual = "powershell" if _WINDOWS else Path(os.environ.get("SHELL", "sh")).name
    names = [_KIN.get(name, name) for name in (parent.removeprefix("-"), usual)]
    return next((name for name in names if name in SHELLS), "sh")


def begin_text(shell: str) -> str:
    """What a shell runs to have the words of ROS, and to find the packages below this folder wherever it goes.

    Args:
        shell: Its name in `SHELLS`.
    """
    here, words = str(Path.cwd()), words_folder()
    workspace = [here] if PackagePath([here], confined=True).packages() else []
    variables = {
        "PATH": [str(words), *_folders("PATH", without=words)],
        PACKAGES: [*workspace, *_folders(PACKAGES, without=here)],
        WORKSPACE: workspace or _folders(WORKSPACE),
    }
    return _text(shell, variables, SHELLS[shell].begin)


def end_text(shell: str) -> str:
    """What a shell runs to be without them again.

    Args:
        shell: Its name in `SHELLS`.
    """
    workspace = os.environ.get(WORKSPACE, "")
    variables = {
        "PATH": _folders("PATH", without=words_folder()),
        PACKAGES: _folders(PACKAGES, without=workspace),
        WORKSPACE: [],
    }
    return _text(shell, variables, SHELLS[shell].end)


def interactive(shell: str, program: str) -> tuple[list[str], dict[str, str]]:
    """The command line of a shell for a person that has the words of ROS, and what its environment has besides.

    The shell reads the person's own settings first.

    Args:
        shell: Its name in `SHELLS`.
        program: Its program.
    """
    kind = SHELLS[shell]
    folder = words_folder().parent / "settings"
    folder.mkdir(exist_ok=True)
    env = [sys.executable, "-P", "-m", "simkit.cli", "env", "--force", "--shell", shell]

    def filled(text: str) -> str:
        return text.replace("@FOLDER@", str(folder)).replace("@ENV@", shlex.join(env))

    for name, text in kind.settings.items():
        (folder / name).write_text(filled(text))
    more = {name: filled(value) for name, value in kind.environment.items()}
    return [program, *map(filled, kind.options)], more


def program_elsewhere(name: str) -> str | None:
    """The file of a program on PATH that is not one of these words; None if there is none."""
    return shutil.which(name, path=os.pathsep.join(_folders("PATH", without=words_folder())))


def _text(shell: str, variables: Mapping[str, Sequence[str]], template: str) -> str:
    assignment = SHELLS[shell].assignment
    lines = [assignment(name, os.pathsep.join(value)) for name, value in variables.items()]
    return "".join(lines) + template.replace("@WORDS@", " ".join(all_words()))


def _folders(variable: str, *, without: str | Path = "") -> list[str]:
    """The folders that a variable of the environment lists."""
    parts = os.environ.get(variable, "").split(os.pathsep)
    return [part for part in parts if part and part != str(without)]


def words_folder() -> Path:
    """A folder with one small program for each word; makes it, or brings it up to date.

    It lies in the environment that simkit is installed in, or, where that is read-only, in the user's own temporary folder.

    Raises:
        OSError: Neither can be written.
        SessionError: The temporary folder belongs to somebody else.
    """
    try:
        return _with_programs(Path(sys.prefix) / "share" / "simkit" / "words")
    except OSError:
        return _with_programs(own_folder() / "words")


def _with_programs(folder: Path) -> Path:
    folder.mkdir(parents=True, exist_ok=True)
    for word in all_words():
        file = folder / (f"{word}.cmd" if _WINDOWS else word)
        text = _program(word)
        if not (file.exists() and file.read_text() == text):
            new = file.with_name(f".{file.name}.{os.getpid()}")
            new.write_text(text)
            new.chmod(0o755)
            new.replace(file)
    return folder


def _program(word: str) -> str:
    """A program that hands its words to simkit, or to grader."""
    module = "grader.cli" if word == "grader" else "simkit.cli"
    first = "" if word in ("grader", "simkit") else f" {word}"
    # -P: a calendar.py in the folder where it is typed is not Python's.
    if _WINDOWS:
        return f'@"{sys.executable}" -P -m {module}{first} %*\n'
    return f'#!/bin/sh\nexec {shlex.quote(sys.executable)} -P -m {module}{first} "$@"\n'
