from __future__ import annotations

import pytest

from simkit.msgs import DefinitionError
from simkit.msgs.definition import parse_definition

TEXT = """
# A comment, then constants of all kinds.
int32 FIRST=1   # one
uint8 SECOND = 255
float64 HALF=0.5
bool YES=True
string NAME= it's # not a comment
Header header
Point[] points          # of the same package
geometry_msgs/Pose[2] poses
float64[36] covariance
string  class
char[4] letters
"""


@pytest.fixture
def definition():
    return parse_definition(TEXT, "some_msgs/Thing")


def test_fields(definition):
    assert [(field.type, field.name) for field in definition.fields] == [
        ("std_msgs/Header", "header"),
        ("some_msgs/Point[]", "points"),
        ("geometry_msgs/Pose[2]", "poses"),
        ("float64[36]", "covariance"),
        ("string", "class"),
        ("char[4]", "letters"),
    ]
    assert definition.has_header
    assert [field.is_octets for field in definition.fields] == [False] * 5 + [True]


def test_constants(definition):
    values = {constant.name: constant.value for constant in definition.constants}
    assert values == {
        "FIRST": 1,
        "SECOND": 255,
        "HALF": 0.5,
        "YES": True,
        "NAME": "it's # not a comment",
    }


def test_reserved_words_get_an_underscore(definition):
    assert definition.fields[4].attribute == "class_"


@pytest.mark.parametrize("line", ["float64", "float64 x y", "1 x", "float64 x = ", "a[b] c"])
def test_a_bad_line_is_named(line):
    if line.endswith("= "):
        assert parse_definition(line, "a/B").constants[0].text == ""
        return
    with pytest.raises(DefinitionError, match=r"a/B, line 2: .*neither 'type name' nor"):
        parse_definition(f"int8 good\n{line}", "a/B")
