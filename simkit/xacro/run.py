"""Runs xacro on a file, within bounds of time and size.

Source: `xacro` of ROS, by its maintainers: the library from the Python package index.
"""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from collections.abc import Sequence
from dataclasses import dataclass

from simkit.errors import SimkitError
from simkit.packages import PackagePath

TIMEOUT = 10.0
"""So long may it compute on the wall [s]; a robot takes less than one."""
MAX_BYTES = 10_000_000
"""Longest text that is taken."""
MOST_LINES = 4
"""So many lines of its complaint are shown, and the last one."""
_NOISE = re.compile(r"<class '[\w.]+'>: | \[Errno \d+\] .*")


class XacroError(SimkitError):
    """xacro cannot make a URDF of the file; the text is what it says.

    Args:
        text: What it says.
        exit_code: Its exit code.
    """

    def __init__(self, text: str, exit_code: int) -> None:
        super().__init__(text)
        self.exit_code = exit_code


@dataclass(frozen=True, slots=True, kw_only=True)
class XacroOutput:
    """What xacro prints when all is well."""

    text: str
    """The URDF; empty if it went into a file."""
    messages: str
    """Its warnings."""


def run_xacro(arguments: Sequence[str], *, packages: PackagePath) -> XacroOutput:
    """What `xacro ARGUMENTS` prints.

    Args:
        arguments: A file, `name:=value` for its arguments, options.
        packages: Where `$(find ...)` looks.

    Raises:
        XacroError: It cannot be done.
    """
    folders = {name: str(one.folder) for name, one in packages.packages().items()}
    request = json.dumps({"packages": folders, "arguments": list(arguments)})
    try:
        done = subprocess.run(
            [sys.executable, "-s", "-P", "-m", "simkit.xacro.child"],
            input=request.encode(),
            capture_output=True,
            timeout=TIMEOUT,
            env={**os.environ, "PYTHONHASHSEED": "0", "PYTHONIOENCODING": "utf-8"},
            check=False,
        )
    except subprocess.TimeoutExpired:
        raise XacroError(f"xacro has not come to an end in {TIMEOUT:g} s", 1) from None
    messages = done.stderr.decode("utf-8", "replace").strip()
    if done.returncode:
        raise XacroError(_complaint(messages), done.returncode)
    if len(done.stdout) > MAX_BYTES:
        raise XacroError(f"the URDF would have more than {MAX_BYTES} bytes", 1)
    return XacroOutput(text=done.stdout.decode("utf-8", "replace"), messages=messages)


def _complaint(messages: str) -> str:
    """What xacro says when it fails, in one line: what is wrong, and what it was doing."""
    lines = _NOISE.sub("", messages).split("Check that:")[0].splitlines()
    parts = [_once(line.strip().removeprefix("error:").strip()) for line in lines if line.strip()]
    if parts and not parts[0]:
        parts[0] = "this is too much"  # memory has run out, and Python has no words for it
    if len(parts) > MOST_LINES + 1:
        parts[MOST_LINES:-1] = ["..."]
    return ", ".join(parts) or "xacro failed without a word"


def _once(line: str) -> str:
    """A message of which the cause says the same again."""
    half = len(line) // 2
    return line[:half] if line[:half] == line[half + 1 :] else line
