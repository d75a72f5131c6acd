"""What the rules say of a robot, and robots in a few words."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from simkit.diagnostics import Diagnostic
from simkit.urdf.rules import Companion, CompanionKind, check_robot
from simkit.xml import parse_xml


def _told(
    text: str, rule: str | None = None, *, launch: str | None = None, yaml: str | None = None
) -> list[Diagnostic]:
    if "<robot " not in text:
        text = f'<robot name="r">\n{text}\n</robot>'
    beside = {
        "robot.launch": (CompanionKind.LAUNCH, launch),
        "controllers.yaml": (CompanionKind.YAML, yaml),
    }
    companions = [
        Companion(kind=kind, file=file, text=content)
        for file, (kind, content) in beside.items()
        if content is not None
    ]
    found = check_robot(parse_xml(text, file="robot.urdf"), companions=companions)
    assert not [one for one in found if "fault of simkit" in one.remedy]
    return [one for one in found if rule is None or one.rule == rule]


@pytest.fixture(scope="session")
def told() -> Callable[..., list[Diagnostic]]:
    """What the rules, or one of them, say of a robot, or of the inside of one."""
    return _told
