"""Evaluation always ends, soon, and with a sentence."""

import time

import pytest

from simkit.launch import LaunchError, evaluate

ENTITIES = "<!ENTITY a 'aaaaaaaaaa'>" + "".join(
    f"<!ENTITY {new} '{('&' + old + ';') * 10}'>"
    for old, new in zip("abcdefgh", "bcdefghi", strict=True)
)
BOMB = f"<?xml version='1.0'?><!DOCTYPE launch [{ENTITIES}]><launch><param name='x' value='&i;'/></launch>"
ALIASES = "a: &a [x, x, x, x, x, x, x, x, x, x]\n" + "".join(
    f"{new}: &{new} [{', '.join(['*' + old] * 10)}]\n"
    for old, new in zip("abcdefgh", "bcdefghi", strict=True)
)
DOUBLING = "<arg name='a0' value='xxxxxxxxxx'/>" + "".join(
    f"<arg name='a{n + 1}' value='$(arg a{n})$(arg a{n})'/>" for n in range(60)
)
MANY = (
    "<arg name='long' value='"
    + "x" * 90_000
    + "'/>"
    + "<param name='a' value='$(arg long)'/>" * 2000
)


@pytest.fixture
def ends_soon():
    start = time.monotonic()
    yield
    assert time.monotonic() - start < 30.0


@pytest.mark.parametrize(
    "text",
    [
        BOMB,
        "<!DOCTYPE launch [<!ENTITY x SYSTEM 'file:///etc/passwd'>]><launch><param name='a' value='&x;'/></launch>",
        f"<launch><rosparam>{ALIASES}</rosparam></launch>",
        f"<launch><param name='a' type='yaml' value='{ALIASES.replace(chr(10), '&#10;')}'/></launch>",
        "<launch><rosparam>a: &amp;a [*a]</rosparam></launch>",
        "<launch><rosparam>" + "[" * 5000 + "</rosparam></launch>",
        "<launch><rosparam>" + "a: [1, 2, 3]\n" * 10_000 + "</rosparam></launch>",
        f"<launch>{DOUBLING}</launch>",
        f"<launch>{MANY}</launch>",
        "<launch>" + "<group>" * 5000 + "</group>" * 5000 + "</launch>",
        "<launch>" + "<param name='a' value='1'/>" * 11_000 + "</launch>",
        "<launch>"
        + "<node name='a' pkg='p' type='t'>"
        + "<remap from='a' to='b'/>" * 11_000
        + "</node></launch>",
        "<launch>"
        + "<param name='~a' value='1'/>" * 900
        + "<node name='n' pkg='p' type='t'/>" * 900
        + "</launch>",
        "<launch>"
        + "".join(f"<param name='~a{n}' value='1'/>" for n in range(2000))
        + "".join(f"<node name='n{n}' pkg='p' type='t'/>" for n in range(2000))
        + "</launch>",
        "<launch><param name='a' value='$(eval " + "9**" * 600 + "9)'/></launch>",
        "<launch><param name='a' value='" + "$(" * 40_000 + "'/></launch>",
    ],
    ids=range(16),
)
def test_a_bomb_is_refused(packages, ends_soon, text):
    with pytest.raises(LaunchError) as caught:
        evaluate(text, packages=packages)
    assert caught.value.remedy
    assert len(str(caught.value)) < 2_500_000


def test_an_external_entity_is_not_read(packages, tmp_path):
    secret = tmp_path / "secret.txt"
    secret.write_text("hunter2")
    text = f"<!DOCTYPE launch [<!ENTITY x SYSTEM '{secret}'>]><launch><param name='a' value='&x;'/></launch>"
    with pytest.raises(LaunchError) as caught:
        evaluate(text, packages=packages)
    assert "hunter2" not in str(caught.value)


def test_a_circle_of_includes_is_named(write, packages, ends_soon):
    first = write("one.launch", '<launch>\n<include file="$(find play)/two.launch"/></launch>')
    write("two.launch", '<launch>\n\n<include file="$(find play)/one.launch"/></launch>')
    with pytest.raises(LaunchError) as caught:
        evaluate(first, packages=packages)
    error = caught.value
    assert error.said == "RecursionError: maximum recursion depth exceeded"
    assert error.diagnostic.what == "play/one.launch includes itself"
    assert (error.file, error.line) == ("play/two.launch", 3)
    assert error.chain == ("play/one.launch:2:2",)


def test_a_tree_of_includes_has_an_end(write, packages, ends_soon):
    for number in range(12):
        inner = f'<include file="$(find play)/{number + 1}.launch"/>' * 4
        write(f"{number}.launch", f"<launch>{inner}</launch>")
    write("12.launch", "<launch/>")
    with pytest.raises(LaunchError, match="launch files are included"):
        evaluate(write.folder / "0.launch", packages=packages)


def test_a_chain_of_includes_has_an_end(write, packages):
    for number in range(40):
        write(
            f"{number}.launch",
            f'<launch><include file="$(find play)/{number + 1}.launch"/></launch>',
        )
    with pytest.raises(LaunchError, match="include each other in a chain"):
        evaluate(write.folder / "0.launch", packages=packages)


def test_large_files_are_not_read(write, packages):
    write("big.urdf", "x" * 11_000_000)
    write("big.launch", "<launch>" + " " * 2_000_000 + "</launch>")
    for text in (
        '<param name="a" textfile="$(find play)/big.urdf"/>',
        '<include file="$(find play)/big.launch"/>',
    ):
        with pytest.raises(LaunchError, match="bytes"):
            evaluate(f"<launch>{text}</launch>", packages=packages)


def test_many_small_files_are_too_much_together(write, packages):
    write("big.txt", "x" * 6_000_000)
    inner = '<param name="a" textfile="$(find play)/big.txt"/>' * 10
    with pytest.raises(LaunchError, match="longer than"):
        evaluate(f"<launch>{inner}</launch>", packages=packages)
