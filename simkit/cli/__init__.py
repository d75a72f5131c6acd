"""`simkit ...`: the command lines of a ROS book, with `simkit` in front.

One file a command, named in `registry`; `main` finds it and turns what goes wrong into one line.
"""

from simkit.cli.main import main

__all__ = ["main"]
