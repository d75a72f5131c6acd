"""Names of topics, frames and namespaces."""

from __future__ import annotations

import pytest

from simkit.plugins import PluginError
from simkit.plugins.site import Site
from simkit.plugins.tag_values import resolve_frame, shown_namespace, tf_prefix, topic_of
from simkit.xml import parse_xml


@pytest.fixture
def site(stage, link):
    """Makes a site of what a tag says, for a model `r`."""
    model = stage.spawn(link()).model

    def make(inside: str = "", namespace: str | None = "/") -> Site:
        root = parse_xml(f"<plugin>\n{inside}\n</plugin>", file="r.urdf").root
        assert root is not None
        return Site(
            node=stage.gazebo.node,
            world=stage.gazebo.world,
            model=model,
            element=root,
            file="r.urdf",
            namespace=namespace,
        )

    return make


@pytest.mark.parametrize(
    ("inside", "namespace", "expected"),
    [
        ("", "/", "/cmd_vel"),
        ("", "/one", "/one/cmd_vel"),
        ("", None, "/r/cmd_vel"),
        ("<robotNamespace>two</robotNamespace>", "/one", "/two/cmd_vel"),
        ("<robotNamespace>/</robotNamespace>", None, "/cmd_vel"),
    ],
)
def test_a_topic_is_in_the_namespace_of_the_tag_or_else_of_who_spawned_the_model(
    site, inside, namespace, expected
):
    assert topic_of(site(inside, namespace), "commandTopic", "cmd_vel") == expected


def test_a_topic_with_a_slash_is_in_no_namespace(site):
    assert topic_of(site("", "/one"), "commandTopic", "/a/b") == "/a/b"


@pytest.mark.parametrize("name", ["", "/", "cmd vel", "~cmd_vel", "a-b", "a//b"])
def test_a_name_that_no_topic_has_is_refused_where_it_stands(site, name):
    place = site(f"<commandTopic>{name}</commandTopic>")
    with pytest.raises(PluginError, match=r"^r\.urdf:2:2: .*<commandTopic>"):
        topic_of(place, "commandTopic", name)


def test_a_namespace_that_none_has_is_refused_where_it_stands(site):
    place = site("<robotNamespace>my robot</robotNamespace>")
    with pytest.raises(PluginError, match=r"^r\.urdf:2:2: .*'/my robot/cmd_vel'"):
        topic_of(place, "commandTopic", "cmd_vel")


@pytest.mark.parametrize(
    ("name", "prefix", "expected"),
    [("odom", "", "odom"), ("/odom", "", "odom"), ("odom", "a", "a/odom"), ("/odom", "a", "odom")],
)
def test_a_frame_gets_the_prefix_unless_it_begins_with_a_slash(name, prefix, expected):
    assert resolve_frame(name, prefix) == expected


def test_the_nearest_prefix_counts(site, stage):
    place = site("", "/one")
    assert tf_prefix(place) == ""
    stage.graph.params.set("/tf_prefix", "all")
    assert tf_prefix(place) == "all"
    stage.graph.params.set("/one/tf_prefix", "/mine/")
    assert tf_prefix(place) == "mine"
    stage.graph.params.set("/one/tf_prefix", 7)
    assert tf_prefix(place) == ""


@pytest.mark.parametrize(
    ("inside", "namespace", "expected"),
    [
        ("", "/", "//"),
        ("", "/one", "/one/"),
        ("", None, "r/"),
        ("<robotNamespace>two</robotNamespace>", "/", "two/"),
    ],
)
def test_the_namespace_is_shown_as_gazebo_ros_shows_it(site, inside, namespace, expected):
    assert shown_namespace(site(inside, namespace)) == expected


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
