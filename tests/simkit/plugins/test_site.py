"""What a plugin is told of its place."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from simkit.plugins.site import Site
from simkit.xml import parse_xml


@pytest.fixture
def site(new_stage, link) -> Callable[..., Site]:
    """Makes the site of a plugin of a model `r`."""

    def make(text: str = "<plugin/>", *, seed: int = 0, name: str = "r", **options) -> Site:
        stage = new_stage(seed)
        root = parse_xml(text, file="r.urdf").root
        assert root is not None
        return Site(
            node=stage.gazebo.node,
            world=stage.gazebo.world,
            model=stage.spawn(link(), name=name).model,
            element=root,
            **options,
        )

    return make


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ('<plugin name="drive" filename="lib.so"/>', "drive"),
        ('<plugin filename="lib.so"/>', "lib.so"),
        ("<plugin/>", "plugin"),
    ],
)
def test_a_plugin_is_called_by_its_name_or_else_by_its_library(site, text, name):
    assert site(text).name == name


TWO = "<plugin><robotNamespace> /two/ </robotNamespace></plugin>"


@pytest.mark.parametrize(
    ("text", "namespace", "expected"),
    [
        ("<plugin/>", None, "r"),
        ("<plugin/>", "/", ""),
        ("<plugin/>", "/one", "one"),
        (TWO, "/one", "two"),
        (TWO, None, "two"),
    ],
)
def test_the_namespace_is_that_of_the_tag_or_of_who_spawned_it_or_the_model(
    site, text, namespace, expected
):
    found = site(text, namespace=namespace)
    assert found.robot_namespace == expected
    assert found.resolve("a/b") == (f"/{expected}/a/b" if expected else "/a/b")
    assert found.resolve("/a/b/") == "/a/b"


def test_its_clock_is_that_of_the_graph(site):
    found = site()
    executor = found.node.graph.executor
    executor.run_to(executor.now_ns + 5_000_000)
    assert found.now_ns == executor.now_ns


def test_what_is_random_depends_on_the_simulation_the_model_and_what_it_is_for(site):
    seed = site(seed=1).seed("noise")
    assert seed == site(seed=1).seed("noise")
    others = [
        site(seed=2).seed("noise"),
        site(seed=1, name="s").seed("noise"),
        site(seed=1).seed("bias"),
        site(seed=1, link="base").seed("noise"),
    ]
    assert len({seed, *others}) == 5
