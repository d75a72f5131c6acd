"""Names, remappings and command lines."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from simkit.graph.errors import GraphError, RosCommandError
from simkit.graph.names import (
    is_legal_name,
    is_legal_node_name,
    namespace_of,
    resolve,
    split_command_line,
)


@pytest.mark.parametrize(
    ("name", "node", "expected"),
    [
        ("pose", "/turtlesim", "/pose"),
        ("/pose", "/turtlesim", "/pose"),
        ("~turtle", "/broadcaster", "/broadcaster/turtle"),
        ("pose", "/left/driver", "/left/pose"),
        ("~x", "/left/driver", "/left/driver/x"),
        ("a/b", "/n", "/a/b"),
        ("pose/", "/n", "/pose"),
        ("", "/left/driver", "/left"),
    ],
)
def test_resolution(name, node, expected):
    assert resolve(name, node) == expected


def test_remapping_applies_to_resolved_names():
    line = split_command_line(["pose:=/turtle2/pose", "~x:=/y"])
    remappings = line.resolved_remappings("/n")
    assert resolve("pose", "/n", remappings) == "/turtle2/pose"
    assert resolve("/pose", "/n", remappings) == "/turtle2/pose"
    assert resolve("~x", "/n", remappings) == "/y"
    assert resolve("other", "/n", remappings) == "/other"


@pytest.mark.parametrize("name", ["1a", "a b", "a-b", "ä", "a//b", "$x", "/a:b"])
def test_illegal_names_are_refused_with_the_name(name):
    assert not is_legal_name(name)
    with pytest.raises(GraphError, match="not a legal name"):
        resolve(name, "/n")


def test_node_names_have_no_slash():
    assert is_legal_node_name("turtle_tf_broadcaster")
    assert not is_legal_node_name("a/b")
    assert not is_legal_node_name("")


def test_command_line_is_split():
    line = split_command_line(
        [
            "fast",
            "_turtle:=turtle2",
            "_rate:=10",
            "_on:=true",
            "_list:=[1, 2]",
            "__name:=b",
            "a:=b",
            "__ns:=/left",
        ]
    )
    assert line.arguments == ("fast",)
    assert line.private_parameters == {"turtle": "turtle2", "rate": 10, "on": True, "list": [1, 2]}
    assert line.node_name == "b"
    assert line.namespace == "/left"
    assert line.remappings == {"a": "b"}


@pytest.mark.parametrize(
    ("argument", "word"),
    [("_x:=[1", "YAML"), ("__name:=a/b", "'/'"), ("a b:=c", "legal"), ("a:=2", "legal")],
)
def test_faults_of_a_command_line_name_the_argument(argument, word):
    with pytest.raises(RosCommandError, match=word):
        split_command_line([argument])


legal = st.from_regex(r"\A[a-z][a-z0-9_]{0,5}(/[a-z][a-z0-9_]{0,5}){0,2}\Z")


@given(legal, legal)
def test_a_resolved_name_resolves_to_itself(name, node):
    resolved = resolve(name, "/" + node)
    assert resolved.startswith("/")
    assert resolve(resolved, "/" + node) == resolved
    assert resolve(resolved, "/elsewhere/node") == resolved


@given(legal)
def test_namespace_of_a_name_is_its_prefix(name):
    assert ("/" + name).startswith(namespace_of("/" + name))
