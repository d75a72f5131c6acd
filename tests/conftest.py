"""What holds for all tests."""

from __future__ import annotations

from hypothesis import settings

# A busy machine is no fault: an example may take as long as it takes.
settings.register_profile("without a clock", deadline=None)
settings.load_profile("without a clock")
