"""Small scripts, and what they print."""

import textwrap

import pytest


@pytest.fixture
def prints(run_script):
    """A function that runs a script given as text and returns what it prints; it must end well."""

    def prints(text, *arguments, seconds=10.0, **options):
        script = "import rospy\n" + textwrap.dedent(text)
        node = run_script(script, *arguments, seconds=seconds, **options)
        assert node.failure is None, node.output
        assert not node.alive, f"still running after {seconds} s: {node.output}"
        assert node.exit_code == 0, node.output
        return node.output

    return prints


@pytest.fixture
def partner(run_script):
    """A function that starts a script given as text, for another one to meet."""

    def partner(text, *arguments, name="partner.py"):
        return run_script("import rospy\n" + textwrap.dedent(text), *arguments, name=name)

    return partner
