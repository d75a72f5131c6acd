"""What holds for every plugin of the registry: its tag, its rate, that it does the same again, and that it goes."""

from __future__ import annotations

import dataclasses
import itertools
import math
from collections.abc import Iterator
from typing import Any, get_type_hints

import pytest

from simkit.graph import LogLevel, ServiceServer
from simkit.graph.graph import Graph
from simkit.msgs import Message, TVal, service_class
from simkit.plugins import Plugin, plugins
from simkit.plugins.registry import tags_of
from tests.laws import broken_laws
from tests.simkit.plugins.samples import Sample, sample_of

FILE = "sample.urdf"
every_plugin = pytest.mark.parametrize("filename", list(plugins()))


def parameters_of(filename: str) -> type[Any]:
    return plugins()[filename].load().Parameters


def bad_values() -> list[tuple[str, str, str]]:
    """Library, tag and text of each value that a plugin must refuse."""
    found = []
    for filename, entry in plugins().items():
        parameters = entry.load().Parameters
        types = get_type_hints(parameters)
        for name, tag in tags_of(parameters).items():
            if types[name] is not str:
                found.append((filename, tag.name, "perhaps"))
            if types[name] in (int, float):
                found.append((filename, tag.name, "nan"))
            bound = max(tag.at_least, tag.above)
            if math.isfinite(bound):
                found.append((filename, tag.name, f"{bound - 1.0:g}"))
            if math.isfinite(tag.above):
                found.append((filename, tag.name, f"{tag.above:g}"))
    return found


class Play:
    """A sample robot with its plugin, spawned; each message of the plugin is heard."""

    def __init__(self, stage: Any, filename: str, *, rate: float = 20.0, **tags: str) -> None:
        self.stage = stage
        self.sample: Sample = sample_of(filename)
        stage.run(0.1)  # a sensor in a world that has just begun waits for a period
        node = stage.gazebo.node
        self.before = endpoints(node)
        self.urdf = self.sample.urdf(filename, rate=rate, **tags)
        stands_for = {"{urdf}": self.urdf, "{rate}": rate}
        for name, value in self.sample.parameters.items():
            stage.graph.params.set(name, replaced(value, stands_for))
        self.spawned = stage.gazebo.spawn_urdf(
            self.urdf, name="sample", pose=stage.at(z=self.sample.height), file=FILE
        )
        self.call()
        new = [one for one in node.publishers if one not in self.before]
        self.heard: dict[str, list[tuple[int, bytes]]] = {one.topic: [] for one in new}
        for one in new:
            self._listen(stage.graph, one.topic, one.message_class)
        self.command()

    def _listen(self, graph: Graph, topic: str, kind: type[Message]) -> None:
        heard, executor = self.heard[topic], graph.executor
        graph.add_subscription(
            topic, kind, "/listener", lambda data, _: heard.append((executor.now_ns, data))
        )

    def call(self) -> None:
        """Call the services that put it to work."""
        if not self.spawned.plugins:
            return
        for name, type_name, fields in self.sample.calls:
            kind: Any = service_class(type_name)
            answers: list[tuple[bool, bytes]] = []
            self.stage.graph.call_service(
                name,
                kind._request_class(**fields).to_bytes(),
                "/listener",
                lambda *answer: answers.append(answer),  # noqa: B023 - answered in this turn
            )
            self.stage.run(0.002)
            ((has_worked, data),) = answers
            assert has_worked
            assert kind._response_class.from_bytes(data).ok, name

    def command(self) -> None:
        """Tell the plugin what to do."""
        for topic, message in self.sample.commands.items():
            self.stage.listener.advertise(topic, type(message)).publish(message)

    def numbers(self, since_ns: int, until_ns: int) -> dict[str, list[list[float]]]:
        """The numbers of each message in a time, with stamps counted from its beginning.

        They are sorted, since contacts come in any order.
        """
        classes = {one.topic: one.message_class for one in self.stage.gazebo.node.publishers}
        return {
            topic: [
                sorted(numbers_of(classes[topic].from_bytes(data), since_ns))
                for time_ns, data in heard
                if since_ns < time_ns <= until_ns
            ]
            for topic, heard in self.heard.items()
        }


def endpoints(node: Any) -> list[Any]:
    return [*node.publishers, *node.subscriptions, *node.servers]


def name_of(endpoint: Any) -> str:
    """Name of a topic or service."""
    return endpoint.name if isinstance(endpoint, ServiceServer) else endpoint.topic


def replaced(value: Any, stands_for: dict[str, Any]) -> Any:
    """A value of a parameter, with what stands in it for something else replaced."""
    if isinstance(value, dict):
        return {name: replaced(one, stands_for) for name, one in value.items()}
    return stands_for.get(value, value)


def numbers_of(value: Any, since_ns: int) -> Iterator[float]:
    """All numbers in a message but those that count messages; stamps in seconds since a time."""
    if isinstance(value, TVal):
        yield (value.to_nsec() - since_ns) * 1e-9
    elif isinstance(value, Message):
        for name in value.__slots__:
            if name != "seq":
                yield from numbers_of(getattr(value, name), since_ns)
    elif isinstance(value, list | tuple):
        for one in value:
            yield from numbers_of(one, since_ns)
    elif isinstance(value, float | int):
        yield float(value)


@every_plugin
def test_its_class_is_a_plugin_with_frozen_parameters(filename):
    kind = plugins()[filename].load()
    assert issubclass(kind, Plugin)
    assert kind is not Plugin
    assert dataclasses.is_dataclass(kind.Parameters)
    assert kind.Parameters.__dataclass_params__.frozen
    assert all(tag.text.endswith(".") for tag in tags_of(kind.Parameters).values())


@every_plugin
def test_its_parameters_are_those_that_check_urdf_knows(filename):
    assert plugins()[filename].load().Parameters is plugins()[filename].parameters


@pytest.mark.parametrize(("filename", "tag", "text"), bad_values())
def test_a_bad_value_is_refused_where_it_stands_and_the_model_is_there_without_the_plugin(
    stage, filename, tag, text
):
    play = Play(stage, filename, **{tag: text})
    line = play.urdf[: play.urdf.index(f"<{tag}>{text}<")].count("\n") + 1
    complaints = stage.said(LogLevel.ERROR)
    assert len(complaints) == 1
    assert complaints[0].startswith(f"{FILE}:{line}:")
    assert f"<{tag}>" in complaints[0]
    assert filename in complaints[0]
    assert play.spawned.plugins == ()
    assert "sample" in stage.gazebo.world.models
    assert endpoints(stage.gazebo.node) == play.before


@every_plugin
def test_its_sample_works_without_complaint(stage, filename):
    play = Play(stage, filename)
    stage.run(0.3)
    assert stage.said(LogLevel.ERROR) == []
    assert len(play.spawned.plugins) == 1
    assert play.heard
    assert all(play.heard.values())


@every_plugin
def test_two_runs_say_the_same_bytes(new_stage, filename):
    plays = [Play(new_stage(seed=3), filename) for _ in range(2)]
    for play in plays:
        play.stage.run(0.5)
    assert plays[0].heard == plays[1].heard


@every_plugin
@pytest.mark.parametrize("rate", [30.0, 100.0])
def test_it_says_the_same_if_it_is_called_in_each_step(new_stage, filename, rate):
    """What it does at the times that it names is all that it does."""
    plays = [Play(new_stage(seed=3), filename, rate=rate) for _ in range(2)]
    plays[1].stage.gazebo.world.due.clear()
    for play in plays:
        play.stage.run(0.5)
    assert plays[0].heard == plays[1].heard


@every_plugin
@pytest.mark.parametrize("rate", [20.0, 100.0])
def test_its_rate_holds(stage, filename, rate):
    play = Play(stage, filename, rate=rate)
    stage.run(0.5)
    for topic, heard in play.heard.items():
        times = sorted({time_ns for time_ns, _ in heard})
        gaps = {after - before for before, after in itertools.pairwise(times)}
        assert gaps == {round(1e9 / rate)}, topic
        assert abs(len(times) - 0.5 * rate) <= 1, topic


@every_plugin
def test_a_reset_puts_it_back(stage, filename):
    if not sample_of(filename).begins_anew:
        pytest.skip("controllers go on as if nothing had happened")
    play, executor = Play(stage, filename), stage.graph.executor
    spans = []
    for _ in range(2):
        begin_ns = executor.now_ns
        play.command()
        stage.run(0.305)
        spans.append((begin_ns, executor.now_ns))
        stage.gazebo.reset_world()
    once, again = (play.numbers(*span) for span in spans)
    for topic in play.heard:
        for one, other in zip(once[topic], again[topic], strict=True):
            assert other == pytest.approx(one, abs=1e-3), topic


@every_plugin
def test_nothing_of_it_is_left_when_its_model_goes(stage, filename):
    world = stage.gazebo.world
    hooks = [*world.before_step, *world.after_step, *world.due]
    play = Play(stage, filename)
    stage.run(0.055)
    stage.gazebo.delete("sample")
    assert endpoints(stage.gazebo.node) == play.before
    assert [*world.before_step, *world.after_step, *world.due] == hooks
    counts = {topic: len(heard) for topic, heard in play.heard.items()}
    stage.run(0.2)
    assert {topic: len(heard) for topic, heard in play.heard.items()} == counts


@every_plugin
def test_two_of_it_do_not_get_into_each_others_way(stage, filename):
    node = stage.gazebo.node
    play = Play(stage, filename)
    mine = endpoints(node)
    stage.graph.params.set("/other/robot_description", play.urdf)
    other = stage.gazebo.spawn_urdf(
        play.urdf, name="other", pose=stage.at(y=3), namespace="/other", file=FILE
    )
    stage.run(0.1)
    assert len(other.plugins) == 1
    names = [name_of(one) for one in endpoints(node) if one not in mine]
    in_namespace = [name for name in names if name.startswith("/other/")]
    broken_laws(
        [] if in_namespace else [f"{filename}: {', '.join(names)}"],
        "a plugin's topics lie in the namespace of its robot: take `site.resolve(name)` or `topic_of`",
    )
    assert not {name for name in names if name != "/tf"} & {name_of(one) for one in mine}
    stage.gazebo.delete("other")
    assert endpoints(node) == mine
    heard = {topic: len(messages) for topic, messages in play.heard.items()}
    stage.run(0.1)
    assert all(len(play.heard[topic]) > count for topic, count in heard.items())
