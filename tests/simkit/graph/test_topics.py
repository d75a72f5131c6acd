"""Topics: who hears what, when, and in which copy."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from simkit.graph import Executor, Graph, GraphError
from simkit.msgs import SerializationError, message_class


def test_messages_come_in_order_at_the_instant_of_publishing(world):
    heard, times = world.hear("/numbers"), []
    world.node.subscribe("/numbers", world.int32, lambda _: times.append(world.executor.now_ns))
    publisher = world.graph.create_node("/mouth").advertise("/numbers", world.int32)
    world.executor.call_at(5, lambda: [publisher.publish(world.int32(i)) for i in range(3)])
    world.run(1)
    assert heard == [0, 1, 2]
    assert times == [5, 5, 5]


def test_a_message_is_not_heard_within_publish_but_after_it(world):
    heard = world.hear("/numbers")
    world.node.advertise("/numbers", world.int32).publish(world.int32(1))
    assert heard == []
    world.run()
    assert heard == [1]


def test_each_subscriber_has_its_own_copy_and_the_publisher_keeps_its_own(world):
    string, kept = world.string, []

    def spoil(message):
        kept.append(message)
        message.data += " spoilt"

    for name in ("/one", "/two"):
        world.graph.create_node(name).subscribe("/words", string, spoil)
    sent = string("word")
    world.node.advertise("/words", string).publish(sent)
    sent.data = "changed after publishing"
    world.run()
    assert [message.data for message in kept] == ["word spoilt", "word spoilt"]
    assert kept[0] is not kept[1]
    assert sent.data == "changed after publishing"


def test_a_message_says_who_sent_it(world):
    headers = []
    world.node.subscribe(
        "/numbers", world.int32, lambda message: headers.append(message._connection_header)
    )
    world.graph.create_node("/mouth").advertise("/numbers", world.int32).publish(world.int32(1))
    world.run()
    assert headers == [{"callerid": "/mouth", "topic": "/numbers", "type": "std_msgs/Int32"}]


def test_a_latching_publisher_greets_who_comes_later_with_its_last_message(world):
    latched = world.node.advertise("/latched", world.int32, latch=True)
    plain = world.node.advertise("/plain", world.int32)
    for number in (1, 2):
        latched.publish(world.int32(number))
        plain.publish(world.int32(number))
    world.run(1)
    assert (world.hear("/latched"), world.hear("/plain")) == ([], [])
    late = world.hear("/latched")
    missed = world.hear("/plain")
    world.run()
    assert late == [2]
    assert missed == []


def test_every_latching_publisher_of_a_topic_greets(world):
    for number in (1, 2):
        node = world.graph.create_node(f"/mouth{number}")
        node.advertise("/latched", world.int32, latch=True).publish(world.int32(number))
    heard = world.hear("/latched")
    world.run()
    assert heard == [1, 2]


def test_a_latched_message_is_gone_with_its_publisher(world):
    publisher = world.node.advertise("/latched", world.int32, latch=True)
    publisher.publish(world.int32(1))
    publisher.unregister()
    heard = world.hear("/latched")
    world.run()
    assert heard == []


@given(st.integers(1, 5), st.integers(0, 12))
def test_a_queue_keeps_the_newest_messages_of_an_instant(queue_size, count):
    graph, number = Graph(Executor()), message_class("std_msgs/Int32")
    heard = []
    graph.create_node("/ear").subscribe(
        "/numbers", number, lambda message: heard.append(message.data), queue_size=queue_size
    )
    publisher = graph.create_node("/mouth").advertise("/numbers", number)
    for i in range(count):
        publisher.publish(number(i))
    graph.executor.run_to(0)
    assert heard == list(range(count))[-queue_size:]


def test_a_queue_drops_nothing_between_instants(world):
    heard = world.hear("/numbers", queue_size=1)
    publisher = world.node.advertise("/numbers", world.int32)
    for number in range(4):
        publisher.publish(world.int32(number))
        world.run(0.1)
    assert heard == [0, 1, 2, 3]


@pytest.mark.parametrize("first", ["publisher", "subscriber"])
def test_two_types_on_one_topic_are_logged_and_not_connected(world, first):
    other = world.graph.create_node("/other")
    words = []
    if first == "publisher":
        publisher = world.node.advertise("/mixed", world.int32)
        subscription = other.subscribe("/mixed", world.string, words.append)
    else:
        subscription = world.node.subscribe("/mixed", world.string, words.append)
        publisher = other.advertise("/mixed", world.int32)
    publisher.publish(world.int32(1))
    world.run()
    assert words == []
    assert (publisher.num_connections, subscription.num_connections) == (0, 0)
    (text,) = world.said("ERROR")
    assert "std_msgs/Int32" in text
    assert "std_msgs/String" in text
    assert "/mixed" in text


def test_a_topic_that_nobody_uses_any_more_takes_another_type(world):
    world.node.advertise("/topic", world.int32).unregister()
    heard = []
    world.node.subscribe("/topic", world.string, lambda message: heard.append(message.data))
    world.node.advertise("/topic", world.string).publish(world.string("word"))
    world.run()
    assert heard == ["word"]
    assert world.graph.topic_types() == {"/topic": "std_msgs/String"}
    assert world.said() == []


def test_a_closed_publisher_refuses_and_a_closed_subscription_is_deaf(world):
    heard = []
    subscription = world.node.subscribe("/numbers", world.int32, heard.append)
    publisher = world.node.advertise("/numbers", world.int32)
    publisher.publish(world.int32(1))
    subscription.unregister()  # what was on its way is dropped
    world.run()
    assert heard == []
    publisher.unregister()
    publisher.unregister()
    with pytest.raises(GraphError, match="closed topic /numbers"):
        publisher.publish(world.int32(2))
    assert world.graph.topic_types() == {}


def test_a_node_forgets_the_endpoints_that_it_closes(world):
    for _ in range(50):
        publisher = world.node.advertise("/numbers", world.int32)
        subscription = world.node.subscribe("/numbers", world.int32, print)
        assert (world.node.publishers, world.node.subscriptions) == ([publisher], [subscription])
        publisher.unregister()
        subscription.unregister()
    assert (world.node.publishers, world.node.subscriptions) == ([], [])


def test_a_subscription_may_close_itself_while_it_hears(world):
    heard = []

    def once(message):
        heard.append(message.data)
        subscription.unregister()

    subscription = world.node.subscribe("/numbers", world.int32, once)
    others = world.hear("/numbers")
    publisher = world.node.advertise("/numbers", world.int32)
    for number in range(3):
        publisher.publish(world.int32(number))
    world.run()
    assert heard == [0]
    assert others == [0, 1, 2]


def test_what_is_wrong_is_refused_where_it_is_published(world):
    publisher = world.node.advertise("/numbers", world.int32)
    with pytest.raises(GraphError, match=r"/numbers carries std_msgs/Int32, not String"):
        publisher.publish(world.string("1"))
    with pytest.raises(SerializationError, match="data"):
        publisher.publish(world.int32("1"))


def test_stamped_messages_are_numbered_by_their_publisher(world):
    header = message_class("geometry_msgs/PoseStamped")
    numbers = []
    world.node.subscribe("/poses", header, lambda message: numbers.append(message.header.seq))
    for _ in range(2):
        publisher = world.node.advertise("/poses", header)
        publisher.publish(header())
        publisher.publish(header())
    world.run()
    assert numbers == [1, 2, 1, 2]


def test_a_message_that_is_offered_is_made_when_somebody_wants_it(world):
    stamped, made = message_class("geometry_msgs/PointStamped"), []
    publisher = world.node.advertise("/points", stamped)

    def offer(x):
        def make():
            made.append(x)
            message = stamped()
            message.point.x = x
            return message

        publisher.offer(make)

    offer(1.0)
    offer(2.0)
    assert made == []
    topic = world.graph.topics["/points"]
    for _ in range(2):
        last = stamped.from_bytes(topic.last)
        assert (last.point.x, last.header.seq, made) == (2.0, 2, [2.0])
    heard = []
    world.node.subscribe("/points", stamped, heard.append)
    offer(3.0)
    world.run()
    assert [(one.point.x, one.header.seq) for one in heard] == [(3.0, 3)]
    publisher.unregister()
    with pytest.raises(GraphError, match="closed"):
        offer(4.0)


def test_connections_are_counted_on_both_ends(world):
    publisher = world.node.advertise("/numbers", world.int32)
    assert publisher.num_connections == 0
    subscription = world.node.subscribe("/numbers", world.int32, print)
    assert (publisher.num_connections, subscription.num_connections) == (1, 1)


def test_topics_in_use_and_topics_that_are_published(world):
    world.node.subscribe("/heard", world.string, print)
    world.node.advertise("/said", world.int32)
    assert world.graph.topic_types() == {"/heard": "std_msgs/String", "/said": "std_msgs/Int32"}
    assert world.graph.topic_types(published=True) == {"/said": "std_msgs/Int32"}
