"""`simkit xacro`: the URDF that a file with macros stands for.

Source: xacro of ROS, options and words.
"""

from __future__ import annotations

import argparse

from simkit.commands.command import Answer, ErrorText, parsed
from simkit.commands.errors import ToolError
from simkit.packages import PATH_VARIABLES, PackagePath
from simkit.xacro import XacroError, run_xacro


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """File, arguments, options: those of xacro itself."""
    parser.usage = "simkit xacro [OPTIONS] FILE [NAME:=VALUE]"
    parser.epilog = (
        "Prints the URDF. NAME:=VALUE sets an argument of the file, <xacro:arg>. $(find PACKAGE) finds the "
        f"packages below this folder and in {' and '.join(PATH_VARIABLES)}."
    )
    parser.add_argument("-o", metavar="FILE", help="write the URDF into a file instead")
    parser.add_argument("--deps", action="store_true", help="print which files are included")
    parser.add_argument("-i", "--inorder", action="store_true", help="has no effect any more")
    parser.add_argument("-q", action="store_true", help="no warnings")
    parser.add_argument("words", metavar="FILE", nargs="+")


def _answer(arguments: argparse.Namespace) -> Answer:
    flags = [f"--{name}" for name in ("deps", "inorder") if getattr(arguments, name)]
    flags += ["-q"] if arguments.q else []
    flags += [] if arguments.o is None else ["-o", arguments.o]
    try:
        output = run_xacro([*flags, *arguments.words], packages=PackagePath())
    except XacroError as error:
        raise ToolError(str(error), exit_code=error.exit_code) from error
    if output.messages:
        yield ErrorText(f"{output.messages}\n")
    yield output.text
    return 0


run = parsed("xacro", add_arguments, _answer)
