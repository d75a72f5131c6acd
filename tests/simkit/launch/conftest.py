"""Launch files as texts, in a folder with the package `play`."""

import textwrap

import pytest

from simkit.launch import LaunchError, evaluate
from simkit.packages import PackagePath


@pytest.fixture
def write(package):
    """A function that writes a file of the package `play`, e.g. `write("launch/a.launch", text)`."""

    def write(path, text):
        file = package.folder / "play" / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(textwrap.dedent(text).lstrip())
        return file

    write.folder = package.folder / "play"
    return write


@pytest.fixture
def packages(package):
    """Where the package `play` is."""
    return PackagePath([package.folder])


@pytest.fixture
def plan(write, packages):
    """A function that evaluates what stands in a `<launch>`, as the file a.launch of `play`."""

    def plan(inner, environment=None, **arguments):
        path = write("a.launch", f"<launch>{inner}</launch>")
        return evaluate(path, packages=packages, arguments=arguments, environment=environment or {})

    return plan


@pytest.fixture
def refusal(plan):
    """A function that gives the error for what stands in a `<launch>`."""

    def refusal(inner, **options):
        with pytest.raises(LaunchError) as caught:
            plan(inner, **options)
        return caught.value

    return refusal
