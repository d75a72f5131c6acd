"""What the warm parent imports while it is idle is there to be imported."""

import importlib.util

import pytest

from grader.run.warm import LATE


@pytest.mark.parametrize("name", LATE)
def test_a_late_module_exists(name):
    # A name that is wrong would only make the checks slower, and nobody would see it.
    assert importlib.util.find_spec(name) is not None
