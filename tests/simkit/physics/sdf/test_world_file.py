"""World files become models in a world; what is not read is named with its place."""

from __future__ import annotations

import math

import pytest

from simkit.diagnostics import Severity
from simkit.physics import GRAVITY, STEP_NS, Plane, WorldFileError
from simkit.physics.sdf import ModelLibrary, plan_model, read_world, read_world_file
from simkit.urdf import Box, Pose

# The world of exercise S.2: its two comments stand the wrong way round.
EMPTY = """<?xml version="1.0" ?>
<sdf version="1.4">
  <world name="default">
    <!-- a global light source -->
    <include>
      <uri>model://ground_plane</uri>
    </include>
    <!-- a ground plane -->
    <include>
      <uri>model://sun</uri>
    </include>
  </world>
</sdf>
"""

CRATE = """<model name="crate"><pose>1 2 0.5 0 0 1.5707963</pose>
  <link name="link">
    <inertial><mass>2</mass><inertia><ixx>0.1</ixx><iyy>0.2</iyy><izz>0.3</izz></inertia></inertial>
    <collision name="hull"><geometry><box><size>1 1 1</size></box></geometry>
      <surface><friction><ode><mu>0.4</mu><mu2>0.4</mu2></ode></friction></surface></collision>
    <visual name="look"><geometry><box><size>1 1 1</size></box></geometry>
      <material><ambient>1 0 0 1</ambient><diffuse>0.5 0.5 0 1</diffuse></material></visual>
  </link></model>"""


def world(inside: str, version: str = "1.6", **options):
    text = f'<sdf version="{version}"><world name="w">{inside}</world></sdf>'
    return read_world(text, file="w.world", **options)


def test_the_empty_world_of_the_book():
    found = read_world(EMPTY, file="empty.world")
    assert found.name == "default"
    assert (found.gravity, found.step_ns) == (GRAVITY, STEP_NS)
    (ground,) = found.models
    assert (ground.name, ground.is_static, ground.uri) == (
        "ground_plane",
        True,
        "model://ground_plane",
    )
    assert isinstance(ground.links[0].collisions[0].geometry, Plane)
    (sun,) = found.lights
    assert (sun.type, sun.direction) == ("directional", (-0.5, 0.1, -0.9))
    assert found.diagnostics == ()


@pytest.mark.parametrize("version", ["1.4", "1.5", "1.6", "1.7"])
def test_a_model_written_in_place(version):
    (crate,) = world(CRATE, version).models
    assert crate.pose == Pose((1.0, 2.0, 0.5), (0.0, 0.0, 1.5707963))
    (link,) = crate.links
    assert (link.inertial.mass, link.inertial.izz, link.inertial.ixy) == (2.0, 0.3, 0.0)
    assert (link.collisions[0].geometry, link.collisions[0].friction) == (Box((1.0, 1.0, 1.0)), 0.4)
    assert link.visuals[0].rgba == (0.5, 0.5, 0.0, 1.0)
    assert not crate.is_static


def test_a_colour_of_gazebo_has_a_name():
    (ground,) = read_world(EMPTY, file="w").models
    assert ground.links[0].visuals[0].material == "Gazebo/Grey"


def test_physics_of_the_world():
    found = world(
        "<gravity>0 0 -1.6</gravity><physics type='ode'><max_step_size>0.002</max_step_size></physics>"
    )
    assert (found.gravity, found.step_ns) == ((0.0, 0.0, -1.6), 2_000_000)
    older = world("<physics type='ode'><gravity>0 0 -3</gravity></physics>", "1.4")
    assert older.gravity == (0.0, 0.0, -3.0)


def test_steps_that_make_no_simulation():
    found = world("<physics><max_step_size>1</max_step_size></physics>")
    assert found.step_ns == STEP_NS
    assert "steps of 1 s" in found.diagnostics[0].what


def test_an_include_names_places_and_fixes_its_model(tmp_path):
    folder = tmp_path / "crate"
    folder.mkdir()
    (folder / "model.sdf").write_text(f'<sdf version="1.6">{CRATE}</sdf>')
    library = ModelLibrary([tmp_path])
    include = "<include><uri>model://crate</uri>{}</include>"
    plain, named = world(
        include.format("")
        + include.format("<name>b</name><pose>0 0 3 0 0 0</pose><static>1</static>"),
        library=library,
    ).models
    assert (plain.name, plain.pose.xyz, plain.is_static) == ("crate", (1.0, 2.0, 0.5), False)
    assert (named.name, named.pose.xyz, named.is_static) == ("b", (0.0, 0.0, 3.0), True)


def test_a_model_that_is_not_there_is_refused_with_place_and_near_names():
    with pytest.raises(WorldFileError) as caught:
        read_world(EMPTY.replace("ground_plane", "groundplane"), file="my.world")
    text = str(caught.value)
    assert text.startswith("my.world:6:8: model://groundplane is not found")
    assert "did you mean 'ground_plane'?" in text
    assert caught.value.diagnostics[0].severity is Severity.ERROR


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "w.world"),
        ("<sdf version='1.6'><world name='w'></sdf>", "w.world:1:"),
        ("<robot name='r'/>", "holds <robot>, not <sdf>"),
        ("<sdf version='1.6'><model name='m'/></sdf>", "no <world>"),
        ("<sdf version='x'><world/></sdf>", "no version of SDF"),
        ("<sdf version='1.6'><world><include/></world></sdf>", "no <uri>"),
        ("<sdf version='1.6'><world><model/></world></sdf>", "has no name"),
    ],
)
def test_what_is_no_world_is_refused_in_one_line(text, words):
    with pytest.raises(WorldFileError, match=words) as caught:
        read_world(text, file="w.world")
    assert "\n" not in str(caught.value)


def test_two_models_of_one_name_are_refused():
    with pytest.raises(WorldFileError, match="two models named crate"):
        world(CRATE + CRATE)


@pytest.mark.parametrize("version", ["1.3", "1.9"])
def test_other_versions_are_read_with_a_warning(version):
    found = world(CRATE, version)
    assert len(found.models) == 1
    assert f"SDF {version} is read as if" in found.diagnostics[0].what


def still(inside: str) -> str:
    """A model that nothing moves, of one link."""
    return f'<model name="m"><static>1</static><link name="l">{inside}</link></model>'


BALL = "<geometry><sphere><radius>1</radius></sphere></geometry>"


@pytest.mark.parametrize(
    ("inside", "words"),
    [
        ("<population/>", "<population> in a <world>"),
        ("<state world_name='default'/>", "<state> in a <world>"),
        ("<modle name='a'/>", "<modle> in a <world>"),
        (still("<kinematic>1</kinematic>"), "<kinematic> in a <link>"),
        (
            still("<collision name='c'><geometry><heightmap/></geometry></collision>"),
            "the shape <heightmap> is not supported",
        ),
        (still("<collision name='c'/>"), "the collision c has no shape"),
        (still("<pose relative_to='x'>0 0 0 0 0 0</pose>"), "relative to 'x'"),
        (still("<pose>0 0 0</pose>"), "<pose> is '0 0 0', not 6 numbers"),
        (still("<inertial><mass>heavy</mass></inertial>"), "<mass> is 'heavy', not a number"),
        (
            still(f"<collision name='c'>{BALL}<surface><bounce/></surface></collision>"),
            "<bounce> in a <surface>",
        ),
        ("<model name='m'></model>", "the model m has no link"),
        ("<model name='m'><link name='l'/></model>", "the link l has no <inertial>"),
    ],
)
def test_what_is_not_read_is_named_with_its_place(inside, words):
    found = world(inside)
    (one,) = found.diagnostics
    assert words in one.what
    assert one.remedy
    assert one.file == "w.world"
    assert one.source[one.span.column - 1 :][: one.span.length].isidentifier()


def test_what_changes_nothing_here_is_not_talked_about():
    assert world("<gui/><scene/><wind/>" + CRATE).diagnostics == ()


def test_plugins_and_sensors_are_kept_for_those_who_know_them():
    found = world(
        "<plugin name='p' filename='libx.so'/><model name='m'><static>true</static><plugin name='q' filename='liby.so'/>"
        "<link name='l'><sensor name='s' type='ray'/></link></model>"
    )
    assert [one.get("name") for one in found.plugins] == ["p"]
    assert [one.get("name") for one in found.models[0].plugins] == ["q"]
    assert [one.get("name") for one in found.models[0].links[0].sensors] == ["s"]


def test_a_file_on_disk(tmp_path):
    path = tmp_path / "my.world"
    path.write_text(EMPTY)
    assert len(read_world_file(path).models) == 1
    with pytest.raises(WorldFileError, match="there is no such file"):
        read_world_file(tmp_path / "my")


def test_a_world_runs_as_it_is_written(new_world):

    found = world("<include><uri>model://ground_plane</uri></include>" + CRATE)
    simulated = new_world(ground=False, gravity=found.gravity, step_ns=found.step_ns)
    for model in found.models:
        simulated.add(plan_model(model), name=model.name, pose=model.pose.transform)
    simulated.run(2_000_000_000)
    crate = simulated.model("crate")
    assert crate.pose.translation == pytest.approx((1.0, 2.0, 0.5), abs=1e-4)
    assert crate.pose.rotation[2] == pytest.approx(math.sin(math.pi / 4), abs=1e-4)
    assert {one.second.model for one in simulated.contacts()} == {"ground_plane"}
