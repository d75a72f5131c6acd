"""Which plugins a model has, and what is said of those that it cannot have."""

from __future__ import annotations

import pytest

CAR = """<robot name="car"><link name="base">
  <inertial><mass value="1"/><inertia ixx="0.1" iyy="0.1" izz="0.1" ixy="0" ixz="0" iyz="0"/></inertial>
  <collision><geometry><sphere radius="0.1"/></geometry></collision>
</link>{}</robot>"""
P3D = """<gazebo><plugin name="p" filename="libgazebo_ros_p3d.so">
  <bodyName>base</bodyName><topicName>truth</topicName></plugin></gazebo>"""


def spawn(gazebo, blocks):
    return gazebo.spawn_urdf(CAR.format(blocks), name="car", file="car.urdf")


def said(sim, level):
    return [record.text for record in sim.log if record.level.name == level]


def test_plugins_work_from_the_spawn_on_and_leave_with_the_model(sim, gazebo):
    assert [type(plugin).__name__ for plugin in spawn(gazebo, P3D).plugins] == ["P3d"]
    recording = sim.record({"/truth": "nav_msgs/Odometry"})
    sim.run(0.5)
    assert len(recording["/truth"]) > 10
    gazebo.delete("car")
    sim.run(0.01)
    many = len(recording["/truth"])
    sim.run(0.5)
    assert len(recording["/truth"]) == many
    assert gazebo.world.before_step == gazebo.world.after_step == []


@pytest.mark.parametrize(
    ("block", "level", "text"),
    [
        (P3D.replace("p3d", "p3b"), "ERROR", "Did you mean libgazebo_ros_p3d.so?"),
        (P3D.replace("p3d", "laser"), "ERROR", 'it stands in a <sensor type="ray">'),
        (P3D.replace("p3d", "camera"), "WARN", "is not simulated here"),
        (P3D.replace("<bodyName>base</bodyName>", ""), "ERROR", "needs <bodyName>"),
    ],
)
def test_one_that_cannot_work_is_named_and_the_model_is_there(sim, gazebo, block, level, text):
    assert spawn(gazebo, block).plugins == ()
    assert any(text in line and "car.urdf:" in line for line in said(sim, level))
    sim.run(0.1)
    assert "car" in gazebo.spawned


def test_a_block_that_names_nothing_has_no_plugins(gazebo):
    assert spawn(gazebo, P3D.replace("<gazebo>", '<gazebo reference="bass">')).plugins == ()


def test_plugins_of_a_world_file_are_in_the_namespace_of_their_model(sim, gazebo):
    drive = """<plugin name="j" filename="libgazebo_ros_joint_state_publisher.so">
      <jointName>axle</jointName></plugin>"""
    sdf = f"""<sdf version="1.6"><model name="fan"><static>0</static><link name="body"/>
      <link name="blade"/><joint name="axle" type="revolute"><parent>body</parent><child>blade</child>
      <axis><xyz>0 0 1</xyz></axis></joint>{drive}</model></sdf>"""
    gazebo.spawn_sdf(sdf, name="fan", namespace=None)
    assert "/fan/joint_states" in sim.topics()
