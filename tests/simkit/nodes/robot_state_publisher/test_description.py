from __future__ import annotations

from simkit.urdf import reading


def test_without_a_robot_it_says_so_and_leaves(stage):
    node = stage.start()
    assert (node.alive, node.exit_code) == (False, 1)
    assert stage.said("ERROR") == ["Could not find parameter robot_description on parameter server"]


def test_a_namespace_is_no_robot(stage):
    stage.load({"arm": "x"})
    assert stage.start().exit_code == 1
    assert stage.said("ERROR") == ["Could not read parameter robot_description on parameter server"]


def test_the_parameter_is_searched_from_the_namespace_outwards(stage):
    stage.load()
    assert stage.start("__ns:=/lab/left").alive


def test_the_parameter_can_be_remapped(stage):
    stage.sim.params.set("/other/robot", stage.arm)
    assert stage.start("robot_description:=/other/robot").alive
    assert stage.start("robot_description:=/other/none").exit_code == 1


def test_a_robot_that_is_refused_is_told_with_its_place(stage):
    stage.load(stage.arm.replace('<link name="hand"/>', '<link name="hand">'))
    node = stage.start()
    assert (node.alive, node.exit_code) == (False, 1)
    assert "not well-formed XML: line 6, column 4" in node.output
    (error,) = stage.said("ERROR")
    assert error.startswith("robot_description:6:")


def test_a_robot_that_is_refused_is_read_once_too(stage, monkeypatch):
    read = []
    original = reading.parse_xml
    monkeypatch.setattr(
        reading, "parse_xml", lambda *args, **more: read.append(1) or original(*args, **more)
    )
    stage.load(stage.arm.replace('<link name="hand"/>', '<link name="torso"/>'))
    assert stage.start().exit_code == 1
    assert len(read) == 1


def test_what_urdfdom_loses_is_told_and_the_rest_is_published(stage):
    broken = '<link name="hand"><visual><geometry/></visual></link>'
    stage.load(stage.arm.replace('<link name="hand"/>', broken))
    node = stage.start()
    assert node.alive
    assert "Could not parse visual element for Link [hand]" in node.output


def test_the_robot_is_read_once(stage):
    stage.load()
    stage.start()
    stage.sim.params.delete("/robot_description")
    stage.tell(hip=0.1)
    assert len(stage.heard()) == 1
