"""All rules whose ids simkit prints, and what there is to know of each: `--explain ID` and `--list-rules`."""

from __future__ import annotations

from functools import cache

from simkit.commands.errors import UsageError
from simkit.diagnostics import Rule
from simkit.diagnostics.table import in_table_order
from simkit.errors import near_names


@cache
def rule_book() -> tuple[Rule, ...]:
    """All rules, by id within their group: robots, their simulation, launch files, worlds."""
    from simkit.launch.rules import ROWS as OF_LAUNCH_FILES
    from simkit.physics.sdf.rules import ROWS as OF_WORLDS
    from simkit.urdf.rules import all_rules

    return in_table_order((*all_rules(), *OF_LAUNCH_FILES, *OF_WORLDS))


def rules_text() -> str:
    """What `--list-rules` prints: a line for each rule."""
    width = max(len(rule.id) for rule in rule_book())
    return "\n".join(
        f"{rule.id:<{width}}  {rule.severity.value:<7}  {rule.title}" for rule in rule_book()
    )


def explanation_of(name: str) -> str:
    """What there is to know of a rule.

    Args:
        name: Its id, or only its letter and number; upper or lower case.

    Raises:
        UsageError: There is none.
    """
    wanted = name.strip().strip("[]").upper()
    found = [rule for rule in rule_book() if wanted in (rule.id, rule.id.partition("-")[2])]
    if not found:
        near = near_names(wanted, [rule.id for rule in rule_book()]) if len(wanted) < 40 else []
        meant = f"; did you mean {' or '.join(near)}?" if near else "; --list-rules lists them"
        raise UsageError(f"simkit check_urdf: no rule {name!r}{meant}")
    return "\n\n".join(map(_explanation, found))


def _explanation(rule: Rule) -> str:
    return f"{rule.id} ({rule.severity.value}): {rule.title}\n\n{rule.explanation}"
