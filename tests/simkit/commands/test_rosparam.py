from __future__ import annotations

import math

import pytest


def test_get(sim, command):
    assert command("rosparam", "get", "/turtlesim/background_r") == "69\n"
    assert command("rosparam", "get", "turtlesim") == (
        "background_b: 255\nbackground_g: 86\nbackground_r: 69\n\n"
    )
    for value, text in (("hello", "hello\n"), ("12", "'12'\n\n"), (True, "true\n"), (1.5, "1.5\n")):
        sim.params.set("/a", value)
        assert command("rosparam", "get", "/a") == text


def test_get_for_people(sim, command):
    sim.params.set("/a", {"text": "1\n2", "word": "12", "list": [1, 2], "deep": {"x": 1.0}})
    assert command("rosparam", "get", "-p", "/a") == (
        "deep:\n  x: 1.0\nlist: - 1\n- 2\ntext: |\n  1\n  2\nword: 12\n"
    )
    assert command("rosparam", "get", "-p", "/a/word") == "12\n"


@pytest.mark.parametrize(
    ("word", "value"),
    [
        ("1", 1),
        ("-1.5", -1.5),
        ("true", True),
        ("'1'", "1"),
        ("", ""),
        ("[1, 2]", [1, 2]),
        ("deg(180)", math.pi),
        ("rad(pi/2)", math.pi / 2),
        ("rad(-pi * 2 + 1 - 3)", -math.pi * 2 - 2),
        ("!degrees 90", math.pi / 2),
        ("!radians 2*pi", 2 * math.pi),
        ("degree", "degree"),
    ],
)
def test_set(sim, command, word, value):
    assert command("rosparam", "set", "/a/b", word) == ""
    assert sim.params.get("/a/b") == pytest.approx(value)
    assert type(sim.params.get("/a/b")) is type(value)


def test_setting_a_mapping_keeps_the_rest(sim, command):
    command("rosparam", "set", "/a", "{x: 1, deep: {y: 2}}")
    command("rosparam", "set", "/a", "{z: 3, deep: {w: 4}}")
    assert sim.params.get("/a") == {"x": 1, "z": 3, "deep": {"y": 2, "w": 4}}


def test_list_and_delete(sim, command):
    command("rosparam", "set", "/a", "{x: 1, y: 2}")
    assert command("rosparam", "list", "/a") == "/a/x\n/a/y\n"
    assert "/turtlesim/background_r" in command("rosparam", "list").split()
    assert command("rosparam", "delete", "/a/x") == ""
    assert sim.params.get("/a") == {"y": 2}


def test_load_and_dump(sim, command, tmp_path):
    file = tmp_path / "all.yaml"
    file.write_text("arm: {joint: elbow, limit: deg(90)}\n---\n_ns: robot\nspeed: 2\n")
    command("rosparam", "load", str(file))
    assert sim.params.get("/arm") == {"joint": "elbow", "limit": math.pi / 2}
    assert sim.params.get("/robot/speed") == 2
    command("rosparam", "load", str(file), "/lab")
    assert sim.params.get("/lab/robot/speed") == 2
    dumped = tmp_path / "dumped.yaml"
    command("rosparam", "dump", str(dumped), "/robot")
    assert dumped.read_text() == "speed: 2\n"
    assert command("rosparam", "dump").startswith("arm:\n  joint: elbow\n")


def test_a_text_file_as_it_is(sim, command, tmp_path):
    file = tmp_path / "robot.urdf"
    file.write_text("<robot/>\n")
    command("rosparam", "set", "-t", str(file), "/robot_description")
    assert sim.params.get("/robot_description") == "<robot/>\n"


@pytest.mark.parametrize(
    ("words", "text"),
    [
        (["get", "/nope"], "ERROR: Parameter [/nope] is not set"),
        (
            ["get", "/turtlesim/backgroun_r"],
            "is not set\nhint: did you mean /turtlesim/background_r?",
        ),
        (["delete", "/nope"], "ERROR: Parameter [/nope] is not set"),
        (["set", "/a", "{x: "], "ERROR: not YAML: "),
        (["set", "/a", "{1: 2}"], "YAML dictionaries must have string keys."),
        (["set", "/a", "null"], "'null' is no value for a parameter"),
        (["set", "/a", "deg(x)"], "ERROR: invalid degree value: deg(x)"),
        (["set", "/a", "rad(pi.real)"], "ERROR: invalid radian expression: rad(pi.real)"),
        (["set", "/a", "rad(1/0)"], "ERROR: invalid radian expression: rad(1/0)"),
        (["set", "/a"], "Please specify a parameter value"),
        (["set", "-t", "nope.txt", "/a"], "file 'nope.txt' does not exist"),
        (["load", "nope.yaml"], "ERROR: file [nope.yaml] does not exist"),
    ],
)
def test_what_is_wrong(refusal, words, text):
    assert text in refusal("rosparam", *words)[0]


def test_a_file_that_is_no_mapping(refusal, tmp_path):
    file = tmp_path / "list.yaml"
    file.write_text("[1, 2]")
    assert "global / can only be set to a dictionary" in refusal("rosparam", "load", str(file))[0]


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (b"a: 1\nb: [1\nc: 2\n", ":3:2: not YAML: expected ',' or ']'"),
        (b"a: deg(x)\n", ":1:4: invalid degree value: deg(x)"),
        (b"a: 2020-02-31\n", "not YAML: day is out of range for month"),
        (b"\xff\xfe", "is not a text in UTF-8"),
        (b"a: 1\nb: ~\n", "ERROR: /b: a parameter cannot be empty (null)"),
        (b"a: 1\nb: [3000000000]\n", "ERROR: /b: 3000000000 is too large"),
        (b"a: 1\nb: 2020-01-01\n", "ERROR: /b: 2020-01-01 is a date in YAML"),
        (b"a: 1\nb: {1: 2}\n", "YAML dictionaries must have string keys"),
        (b"a: &a [*a]\n", "unfolds to more than"),
        (b"a: " + b"[" * 200 + b"]" * 200, "unfolds to more than"),
        (b"a: &a {k: 1, l: 2}\n" + b"".join(
            b"%c: &%c {%s}\n" % (new, new, b", ".join(b"k%d: *%c" % (n, old) for n in range(9)))
            for old, new in zip(b"abcdefg", b"bcdefgh", strict=True)
        ), "unfolds to more than"),
    ],
)  # fmt: skip
def test_a_file_that_cannot_be_loaded_changes_nothing(sim, refusal, tmp_path, text, words):
    before = sim.params.get("/")
    file = tmp_path / "a.yaml"
    file.write_bytes(text)
    said = refusal("rosparam", "load", str(file))[0]
    assert words in said
    assert sim.params.get("/") == before


def test_files_that_cannot_be_read_or_written(refusal, tmp_path):
    (tmp_path / "b").write_bytes(b"\xff")
    assert "not a text in UTF-8" in refusal("rosparam", "set", "-t", str(tmp_path / "b"), "/a")[0]
    assert "cannot be written" in refusal("rosparam", "dump", str(tmp_path / "no" / "f"))[0]
