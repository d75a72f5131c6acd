"""What a listener hears while its node sleeps: nothing is lost, and no turn of the node is spent on it."""

import pytest

from simkit.graph.process import ScriptNode
from simkit.msgs import Duration, message_class

LISTENERS = {
    "tf": "import tf; listener = tf.TransformListener(); look = listener.lookupTransform",
    "tf2_ros": "import tf2_ros; buffer = tf2_ros.Buffer(); tf2_ros.TransformListener(buffer); "
    "look = buffer.lookup_transform",
}


@pytest.fixture
def broadcast(sim):
    """A function that says every 10 ms where b is in a: at x = seconds since the start."""

    def broadcast(*, rotation=1.0):
        node = sim.graph.create_node("/broadcaster")
        message, stamped = message_class("tf2_msgs/TFMessage"), "geometry_msgs/TransformStamped"
        mouth = node.advertise("/tf", message)
        start = node.now()

        def say():
            transform = message_class(stamped)()
            transform.header.stamp = node.now()
            transform.header.frame_id, transform.child_frame_id = "a", "b"
            transform.transform.translation.x = (node.now() - start).to_sec()
            transform.transform.rotation.w = rotation
            mouth.publish(message([transform]))

        node.create_timer(Duration.from_sec(0.01), say)

    return broadcast


@pytest.fixture
def turns(monkeypatch):
    """Names of the nodes that were given a turn, one by one."""
    given = []
    turn = ScriptNode._turn

    def counted(node, *, send):
        given.append(node.name)
        turn(node, send=send)

    monkeypatch.setattr(ScriptNode, "_turn", counted)
    return given


@pytest.mark.parametrize("module", LISTENERS)
def test_a_node_that_wakes_knows_all_that_was_said_meanwhile(module, partner, broadcast, turns):
    broadcast()
    script = f"""
        rospy.init_node('ear')
        {LISTENERS[module]}
        rospy.sleep(0.105)
        for _ in range(10):
            latest = look('a', 'b', rospy.Time(0))
            past = look('a', 'b', rospy.Time.now() - rospy.Duration(0.055))
            place = latest.transform.translation.x if hasattr(latest, 'transform') else latest[0][0]
            before = past.transform.translation.x if hasattr(past, 'transform') else past[0][0]
            print(round(place, 6), round(before, 6))
            rospy.sleep(0.1)
        """
    node = partner(script)
    del turns[:]
    node.graph.executor.run_to(node.graph.executor.now_ns + 2_000_000_000)
    seen = [tuple(map(float, line.split())) for line in node.output.splitlines()]
    assert seen == [(round(0.1 * n, 6), round(0.1 * n - 0.05, 6)) for n in range(1, 11)]
    # 110 messages came meanwhile, and two topics were subscribed
    assert len(turns) < 20


def test_a_node_that_only_spins_says_at_once_what_is_wrong(partner, broadcast, sim):
    broadcast(rotation=0.0)
    partner("import tf\nrospy.init_node('ear')\nlistener = tf.TransformListener()\nrospy.spin()")
    sim.run(0.015)
    assert [record.node for record in sim.graph.records if "TF_DENORMALIZED" in record.text]


def test_a_node_that_sleeps_for_long_is_told_before(partner, broadcast, sim):
    broadcast(rotation=0.0)
    partner("import tf\nrospy.init_node('ear')\nlistener = tf.TransformListener()\nrospy.sleep(60)")
    sim.run(0.015)
    assert [record.node for record in sim.graph.records if "TF_DENORMALIZED" in record.text]


def test_a_callback_of_its_own_on_tf_hears_each_message_when_it_comes(partner, broadcast, sim):
    broadcast()
    node = partner("""
        import tf
        from tf2_msgs.msg import TFMessage
        rospy.init_node('ear')
        listener = tf.TransformListener()
        def on_transforms(message):
            late = rospy.Time.now() - message.transforms[0].header.stamp
            place, _ = listener.lookupTransform('a', 'b', message.transforms[0].header.stamp)
            print(late.to_sec(), round(place[0], 6))
        rospy.Subscriber('/tf', TFMessage, on_transforms)
        rospy.sleep(0.055)
        """)
    sim.run(0.2)
    assert node.output.splitlines() == [f"0.0 {n / 100}" for n in range(1, 6)]


WAITS = {
    "tf": "listener.waitForTransform('a', 'b', when, rospy.Duration(0.5))",
    "tf2_ros": "assert buffer.can_transform('a', 'b', when, rospy.Duration(0.5))",
}


@pytest.mark.parametrize("others", ["", "rospy.Timer(rospy.Duration(0.003), lambda event: None)"])
@pytest.mark.parametrize("module", LISTENERS)
def test_a_wait_ends_at_the_look_that_finds_it(module, others, partner, broadcast, turns):
    broadcast()
    node = partner(f"""
        rospy.init_node('ear')
        {LISTENERS[module]}
        {others}
        rospy.sleep(0.0985)
        start = rospy.Time.now()
        for ahead in (0.0, 0.101, 0.2):
            when = start + rospy.Duration(ahead)
            begin = rospy.Time.now()
            {WAITS[module]}
            print((rospy.Time.now() - begin).to_nsec() // 1000)
        """)
    del turns[:]
    node.graph.executor.run_to(node.graph.executor.now_ns + 1_000_000_000)
    assert node.failure is None, node.output
    # It looks every 5 ms, from 98.5 ms on; messages come at 100, 110, 120 ms, and so on.
    assert node.output.split() == ["5000", "100000", "100000"]
    assert others or len(turns) < 35


@pytest.mark.parametrize("module", LISTENERS)
def test_a_wait_in_vain_ends_in_time_and_costs_nothing(module, partner, turns):
    node = partner(f"""
        rospy.init_node('ear')
        {LISTENERS[module]}
        begin, when = rospy.Time.now(), rospy.Time(0)
        try:
            {WAITS[module]}
        except Exception as error:
            print(type(error).__name__)
        print((rospy.Time.now() - begin).to_nsec() // 1000000)
        """)
    del turns[:]
    node.graph.executor.run_to(node.graph.executor.now_ns + 2_000_000_000)
    assert node.output.split()[-1] in ("500", "501", "502")
    assert len(turns) < 6
