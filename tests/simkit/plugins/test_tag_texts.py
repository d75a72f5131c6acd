"""Names of plugins whose namespace is empty if nobody gives one."""

from __future__ import annotations

import pytest

MODEL = """<sdf version="1.6"><model name="m"><link name="base">
  <inertial><mass>1</mass></inertial></link>
  <plugin name="imu" filename="libgazebo_ros_imu.so">{0}<bodyName>base</bodyName><topicName>imu</topicName></plugin>
</model></sdf>"""


@pytest.mark.parametrize(
    ("tag", "namespace", "topic"),
    [
        ("", None, "/imu"),
        ("", "/car", "/car/imu"),
        ("<robotNamespace>own</robotNamespace>", None, "/own/imu"),
        ("<robotNamespace>/</robotNamespace>", "/car", "/imu"),
    ],
)
def test_where_the_names_of_the_old_imu_are(stage, tag, namespace, topic):
    stage.gazebo.spawn_sdf(MODEL.format(tag), name="m", namespace=namespace, file="m.sdf")
    assert topic in stage.graph.topics
