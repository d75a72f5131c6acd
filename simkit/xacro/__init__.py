"""xacro: robots written with macros, made URDFs by the program of that name.

`run` starts it as a process of its own, for it computes what a file asks for; `child` is that process.
"""

from simkit.xacro.run import XacroError, run_xacro

__all__ = ["XacroError", "run_xacro"]
