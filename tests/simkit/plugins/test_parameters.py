"""Parameters: a dataclass reads a tag, and says where the tag is wrong; names of topics, frames and namespaces."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import pytest

from simkit.plugins import PluginError
from simkit.plugins.parameters import (
    read_parameters,
    resolve_frame,
    shown_namespace,
    tf_prefix,
    topic_of,
)
from simkit.plugins.registry import tag, tags_of
from simkit.plugins.site import Site
from simkit.xml import parse_xml


@dataclass(frozen=True, slots=True, kw_only=True)
class Words:
    """One of each kind."""

    name: str = tag("wheelName", "front", "Name.")
    size: float = tag("wheelSize", 0.5, "Size [m].", above=0.0)
    rate: float = tag("updateRate", 100.0, "Rate [Hz].", at_least=0.0)
    count: int = tag("wheelCount", 4, "How many.")
    is_on: bool = tag("publishTf", True, "Whether it is on.")
    kind: str = tag("wheelKind", "round", "Kind.", choices=("round", "square"))


@dataclass(frozen=True, slots=True, kw_only=True)
class Needs:
    """One that must be there."""

    body: str = tag("bodyName", "", "Link.", required=True)


@pytest.fixture
def site(stage, link) -> Callable[..., Site]:
    """Makes the site of a plugin whose tag has this in it, from its second line on."""
    model = stage.spawn(link()).model

    def make(inside: str, namespace: str | None = None) -> Site:
        root = parse_xml(f'<plugin name="p">\n{inside}</plugin>', file="r.urdf").root
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


def test_what_is_not_said_is_as_the_class_says(site):
    assert read_parameters(Words, site("")) == Words()


def test_what_is_said_is_read_without_the_white_space_around(site):
    found = read_parameters(
        Words,
        site(
            "<wheelName> rear </wheelName><wheelSize>\n 1e-1\t</wheelSize><updateRate>0</updateRate>"
            "<wheelCount>3</wheelCount><publishTf>false</publishTf><wheelKind>square</wheelKind>"
        ),
    )
    assert found == Words(name="rear", size=0.1, rate=0.0, count=3, is_on=False, kind="square")


@pytest.mark.parametrize(
    ("text", "value"),
    [("true", True), ("1", True), ("TRUE", True), ("false", False), ("0", False), ("False", False)],
)
def test_true_and_false_are_written_as_in_sdf(site, text, value):
    assert read_parameters(Words, site(f"<publishTf>{text}</publishTf>")).is_on is value


@pytest.mark.parametrize(
    ("tags", "complaint"),
    [
        ("<wheelSize>wide</wheelSize>", "<wheelSize> is a number, not 'wide'. Size [m]."),
        ("<wheelSize>nan</wheelSize>", "<wheelSize> is a number, not 'nan'"),
        ("<wheelSize>inf</wheelSize>", "<wheelSize> is a number, not 'inf'"),
        ("<wheelSize>1_0</wheelSize>", "<wheelSize> is a number, not '1_0'"),
        ("<wheelSize/>", "<wheelSize> is a number, not ''"),
        ("<wheelSize>0</wheelSize>", "<wheelSize> is 0, and must be positive"),
        ("<updateRate>-1</updateRate>", "<updateRate> is -1, and must be at least 0"),
        ("<wheelCount>1.5</wheelCount>", "<wheelCount> is a whole number, not '1.5'"),
        ("<publishTf>yes</publishTf>", "<publishTf> is true or false, not 'yes'"),
        ("<wheelKind>flat</wheelKind>", "<wheelKind> is 'flat', and must be one of: round, square"),
    ],
)
def test_a_wrong_value_is_refused_where_it_stands(site, tags, complaint):
    with pytest.raises(PluginError) as caught:
        read_parameters(Words, site(f"<wheelName>a</wheelName>\n  {tags}"))
    assert str(caught.value).startswith("r.urdf:3:4: ")
    assert complaint in str(caught.value)


def test_what_must_be_there_is_asked_for(site):
    with pytest.raises(PluginError, match=r"^r\.urdf:1:2: the plugin p needs <bodyName>: Link\.$"):
        read_parameters(Needs, site(""))


def test_who_speaks_tells_what_is_missing_in_the_order_of_the_class(stage, site):
    read_parameters(Words, site("<wheelCount>3</wheelCount>"), speaker="Drive")
    assert stage.said() == [
        "Drive: missing <wheelName> default is front",
        "Drive: missing <wheelSize> default is 0.5",
        "Drive: missing <updateRate> default is 100",
        "Drive: missing <publishTf> default is true",
        "Drive: missing <wheelKind> default is round",
    ]


def test_who_does_not_speak_takes_defaults_in_silence(stage, site):
    read_parameters(Words, site(""))
    assert stage.said() == []


def test_a_tag_that_is_not_read_is_named_with_the_nearest_that_is(stage, site):
    read_parameters(Words, site("<wheelsize>1</wheelsize>\n<colour>red</colour>"))
    assert stage.said() == [
        "r.urdf:2:2: the plugin p does not read <wheelsize>; did you mean <wheelSize>?",
        "r.urdf:3:2: the plugin p does not read <colour>",
    ]


def test_tags_that_any_plugin_may_have_are_not_strange(stage, site):
    read_parameters(Words, site("<robotNamespace>/</robotNamespace><alwaysOn>1</alwaysOn>"))
    assert stage.said() == []


def test_of_two_equal_tags_the_first_counts(site):
    twice = site("<wheelName>one</wheelName><wheelName>two</wheelName>")
    assert read_parameters(Words, twice).name == "one"


def test_the_class_says_its_tags_by_field():
    assert {field: one.name for field, one in tags_of(Needs).items()} == {"body": "bodyName"}


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
    place = site(f"<commandTopic>{name}</commandTopic>", "/")
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
