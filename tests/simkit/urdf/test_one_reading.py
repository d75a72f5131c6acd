"""One reading: a headless launch of a robot parses each text once."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import pytest

from simkit import Simulation
from simkit.urdf import load_robot, read_robot, reading
from simkit.xml import parse_xml, parser

ROBOTS = Path(__file__).parents[3] / "robots"


@pytest.fixture
def parsed(monkeypatch):
    """How often each text was parsed."""
    counts: Counter[str] = Counter()
    original = parser._read

    def counted(decoded):
        counts[decoded.text] += 1
        return original(decoded)

    monkeypatch.setattr(parser, "_read", counted)
    parser._read_once.cache_clear()
    reading._kept.cache_clear()
    return counts


def test_a_headless_launch_parses_each_text_once(parsed):
    with Simulation(package_path=[ROBOTS], screen=None) as sim:
        sim.roslaunch("my_robot_urdf", "spawn_urdf.launch")
        sim.run(1.0)
        text = sim.params.get("/robot_description")
        assert sim.gazebo.world.models
    assert parsed[text] == 1
    assert set(parsed.values()) == {1}
    assert len([one for one in parsed if "<launch" in one]) >= 2


def test_who_asks_for_the_same_robot_gets_the_same_links(parsed):
    text = '<robot name="r"><link name="a"/></robot>'
    one, other = load_robot(text, file="a.urdf"), load_robot(text, file="b.urdf")
    assert one.links["a"] is other.links["a"]
    assert parse_xml(text.encode(), file="c").root is one.document.root
    assert parsed[text] == 1


def test_faults_are_reported_once_to_each_simulation():
    text = '<robot name="r"/>'
    with Simulation(screen=None) as sim, Simulation(screen=None) as other:
        asked = [sim.graph, other.graph, sim.graph]
        answers = [read_robot(text, file="").is_first_report_to(one) for one in asked]
    assert answers == [True, True, False]


def test_a_robot_with_meshes_is_looked_at_anew(tmp_path):
    """A mesh that was missing may be there the next time."""
    mesh = '<geometry><mesh filename="a.stl"/></geometry>'
    text = f'<robot name="r"><link name="a"><visual>{mesh}</visual></link></robot>'

    def path():
        return load_robot(text, file="a.urdf", folder=tmp_path).links["a"].visuals[0].geometry.path

    assert path() is None
    (tmp_path / "a.stl").touch()
    assert path() == tmp_path / "a.stl"
