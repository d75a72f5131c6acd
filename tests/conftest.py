"""What holds for all tests."""

from __future__ import annotations

import pytest
from hypothesis import settings

LONGEST = ("tests/workbook/", "fuzz")
"""Parts of the names of tests that take longest."""

# A busy machine is no fault: an example may take as long as it takes.
settings.register_profile("without a clock", deadline=None)
settings.load_profile("without a clock")


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """The longest first: one that began last would keep one core waiting for the other."""
    items.sort(key=lambda item: not any(part in item.nodeid for part in LONGEST))
