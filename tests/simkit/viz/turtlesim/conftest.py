from __future__ import annotations

import pytest


@pytest.fixture
def drive(drive_turtle):
    return drive_turtle
