"""`simkit ...`: the command lines of a ROS book, with `simkit` in front.

`main` finds a command in `simkit.commands.table`, runs it, and turns what goes wrong into one line; `terminals` is how
terminals have one simulation.
"""

from simkit.cli.main import main

__all__ = ["main"]
