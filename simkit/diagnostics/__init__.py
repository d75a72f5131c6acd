"""Diagnostics: what is wrong in a file, where, what it does here and in Gazebo, and what would be right.

`table` has the rows: each is a `Rule` with a stable id (`URDF-W07`), for one kind of fault; a `Find` is a place where it is. A
`Diagnostic` is what people read. How that looks on a terminal and as JSON is in `show`.
"""

from simkit.diagnostics.diagnostic import Diagnostic, Related, Severity, in_order
from simkit.diagnostics.show import Layout, as_json, as_text, count_text
from simkit.diagnostics.table import Find, Part, Rule, rule

__all__ = [
    "Diagnostic",
    "Find",
    "Layout",
    "Part",
    "Related",
    "Rule",
    "Severity",
    "as_json",
    "as_text",
    "count_text",
    "in_order",
    "rule",
]
