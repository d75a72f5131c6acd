"""Diagnostics: what is wrong in a file, where, what it does here and in Gazebo, and what would be right.

A `Rule` finds one kind of mistake and has a stable id (`URDF-W07`); a `Diagnostic` is one find. How
they look on a terminal and as JSON is in `show`.
"""

from simkit.diagnostics.diagnostic import Diagnostic, Related, Severity, in_order
from simkit.diagnostics.rule import MetRule, Rule
from simkit.diagnostics.show import as_json, as_text, summary

__all__ = [
    "Diagnostic",
    "MetRule",
    "Related",
    "Rule",
    "Severity",
    "as_json",
    "as_text",
    "in_order",
    "summary",
]
