"""rospy: publishers and subscribers."""

import pytest

TWIST_FORMS = {
    "instance": "pub.publish(Twist(Vector3(1.5, 0, 0), Vector3(0, 0, 0.5)))",
    "positional": "pub.publish(Vector3(1.5, 0, 0), Vector3(0, 0, 0.5))",
    "keywords": "pub.publish(linear=Vector3(x=1.5), angular=Vector3(z=0.5))",
    "filled": "t = Twist(); t.linear.x = 1.5; t.angular.z = 0.5; pub.publish(t)",
    "numpy": "import numpy; pub.publish(Twist(Vector3(*numpy.array([1.5, 0, 0])), Vector3(0, 0, numpy.float64(0.5))))",
    "integers": "pub.publish(Twist(Vector3(1.5, 0, 0), Vector3(False, 0, 0.5)))",
}


@pytest.mark.parametrize("call", TWIST_FORMS.values(), ids=TWIST_FORMS)
def test_forms_of_publishing(prints, sim, call):
    record = sim.record({"/cmd_vel": "geometry_msgs/Twist"})
    prints(
        f"""
        from geometry_msgs.msg import Twist, Vector3
        rospy.init_node('x')
        pub = rospy.Publisher('cmd_vel', Twist, queue_size=10)
        {call}
        """
    )
    ((_, twist),) = record["/cmd_vel"]
    assert (twist.linear.x, twist.angular.z) == (1.5, 0.5)


SIMPLE_FORMS = ["pub.publish('hello')", "pub.publish(String('hello'))", "pub.publish(data='hello')"]


@pytest.mark.parametrize("call", SIMPLE_FORMS)
def test_forms_of_publishing_one_field(prints, sim, call):
    record = sim.record({"/words": "std_msgs/String"})
    prints(
        f"""
        from std_msgs.msg import String
        rospy.init_node('x')
        pub = rospy.Publisher('/words', String, queue_size=10)
        {call}
        """
    )
    assert [message.data for _, message in record["/words"]] == ["hello"]


HEAD = """
        from geometry_msgs.msg import Twist, Vector3
        from std_msgs.msg import Empty, Float64, Int32, String
        from turtlesim.msg import Pose
        rospy.init_node('x')
        pub = rospy.Publisher('/cmd_vel', Twist, queue_size=10)
        words = rospy.Publisher('/words', String, queue_size=10)
        numbers = rospy.Publisher('/numbers', Int32, queue_size=10)
        floats = rospy.Publisher('/floats', Float64, queue_size=10)
"""
PUBLISH_ERRORS = {
    "another message": (
        "pub.publish(Pose())",
        "TypeError: expected [geometry_msgs/Twist] but got [turtlesim/Pose]",
    ),
    "class for instance": ("pub.publish(Twist)", "TypeError"),
    "too few fields": ("pub.publish(Vector3())", "TypeError"),
    "args and keywords": (
        "pub.publish(Vector3(), angular=Vector3())",
        "TypeError: publish() can be called with arguments or keywords, but not both.",
    ),
    "unknown keyword": (
        "pub.publish(liner=Vector3())",
        "AttributeError: liner is not an attribute of Twist",
    ),
    "text for number": (
        "t = Twist(); t.linear.x = '1'; pub.publish(t)",
        "ROSSerializationException: field linear.x must be float type",
    ),
    "number for text": ("words.publish(5)", "ROSSerializationException: field data must be"),
    "float for integer": ("numbers.publish(1.5)", "ROSSerializationException"),
    "too large": ("numbers.publish(2**40)", "ROSSerializationException"),
    "array for number": (
        "import numpy; floats.publish(numpy.zeros(2))",
        "ROSSerializationException: field data",
    ),
    "unregistered": (
        "words.unregister(); words.publish('x')",
        "ROSException: publish() to an unregistered() handle",
    ),
    "misspelt field": ("t = Twist(); t.liner = 1", "AttributeError"),
}


@pytest.mark.parametrize(("call", "error"), PUBLISH_ERRORS.values(), ids=PUBLISH_ERRORS)
def test_what_cannot_be_published(run_script, call, error):
    node = run_script("import rospy" + HEAD.replace("        ", "") + call + "\n", seconds=0.1)
    assert error in node.failure.text
    assert node.failure.line == HEAD.count("\n") + 1


MAKE_ERRORS = {
    "instance for class": (
        "rospy.Publisher('x', String('a'), queue_size=1)",
        "ValueError: data_class",
    ),
    "no class": (
        "rospy.Publisher('x', 'std_msgs/String', queue_size=1)",
        "ValueError: data_class [std_msgs/String] is not a message data class",
    ),
    "module for class": (
        "import std_msgs.msg; rospy.Subscriber('x', std_msgs.msg, print)",
        "ValueError: data_class",
    ),
    "swapped": (
        "rospy.Publisher(String, 'x', queue_size=1)",
        "ValueError: topic name is not a non-empty string",
    ),
    "empty name": (
        "rospy.Publisher('', String, queue_size=1)",
        "ValueError: topic name is not a non-empty string",
    ),
    "spaces": (
        "rospy.Publisher('two words', String, queue_size=1)",
        "ROSException: 'two words' is not a legal name",
    ),
    "called callback": (
        "rospy.Subscriber('x', String, print('a'), 'b', 0)",
        "ROSException: queue size may not be set to zero",
    ),
    "callback": (
        "rospy.Subscriber('x', String, 'print')",
        "ValueError: callback is not a function",
    ),
    "queue": (
        "rospy.Subscriber('x', String, print, queue_size='1')",
        "ROSException: queue size must be an integer",
    ),
    "nothing": ("rospy.Subscriber()", "TypeError"),
}


@pytest.mark.parametrize(("call", "error"), MAKE_ERRORS.values(), ids=MAKE_ERRORS)
def test_what_is_no_publisher_or_subscriber(run_script, call, error):
    text = f"import rospy\nfrom std_msgs.msg import String\nrospy.init_node('x')\n{call}\n"
    node = run_script(text, seconds=0.1)
    assert error in node.failure.text
    assert node.failure.line == 4


def test_a_publisher_without_queue_size_is_warned_at_its_line(prints):
    text = """
        from std_msgs.msg import String
        rospy.init_node('x')
        rospy.Publisher('words', String)
        """
    output = prints(text)
    assert (
        "script.py:5: SyntaxWarning: The publisher should be created with an explicit keyword"
        in output
    )


def test_publishers_and_subscribers_made_before_init_node_work_after_it(prints, sim):
    sim.rostopic_pub("/in", "std_msgs/String", "hello", rate=10)
    record = sim.record({"/out": "std_msgs/String"})
    prints(
        """
        from std_msgs.msg import String
        pub = rospy.Publisher('out', String, queue_size=10)
        sub = rospy.Subscriber('in', String, lambda msg: pub.publish(msg.data + ' back'))
        try:
            pub.publish('too early')
        except rospy.ROSException as error:
            print(error)
        rospy.init_node('echo')
        rospy.sleep(0.25)
        """
    )
    assert {message.data for _, message in record["/out"]} == {"hello back"}


def test_publishing_before_init_node_says_so(run_script):
    node = run_script(
        """
        import rospy
        from std_msgs.msg import String
        rospy.Publisher('out', String, queue_size=10).publish('x')
        """,
        seconds=0.1,
    )
    text = "ROSException: ROS node has not been initialized yet. Please call init_node() first"
    assert text in node.failure.text


def test_a_latched_message_waits_for_who_comes_later(prints, partner, sim):
    partner(
        """
        from std_msgs.msg import String
        rospy.init_node('map_server')
        pub = rospy.Publisher('map', String, latch=True, queue_size=1)
        pub.publish('old')
        pub.publish('new')
        rospy.spin()
        """
    )
    sim.run(1)
    text = """
        from std_msgs.msg import String
        rospy.init_node('reader')
        rospy.Subscriber('map', String, lambda msg: print('heard', msg.data))
        print(rospy.wait_for_message('map', String, timeout=1).data)
        """
    assert sorted(prints(text).split("\n")) == ["", "heard new", "new"]


def test_headers_are_numbered_and_say_who_sent_them(prints):
    text = """
        from geometry_msgs.msg import PoseStamped
        rospy.init_node('both')
        def hear(msg):
            print(msg.header.seq, msg.header.frame_id, msg._connection_header['callerid'], msg._connection_header['topic'])
        rospy.Subscriber('poses', PoseStamped, hear)
        pub = rospy.Publisher('poses', PoseStamped, queue_size=10)
        pose = PoseStamped()
        pose.header.frame_id = 'map'
        for _ in range(3):
            pub.publish(pose)
        rospy.sleep(0.1)
        """
    lines = prints(text).splitlines()
    assert [line.split()[:3] for line in lines] == [[str(i), "map", "/both"] for i in (1, 2, 3)]


ARGS = {
    "one": ("lambda msg, name: print(name, msg.data)", "'turtle1'", "turtle1 hello"),
    "a tuple": ("lambda msg, args: print(*args, msg.data)", "(1, 'two')", "1 two hello"),
    "a falsy one": ("lambda msg, args: print(args, msg.data)", "0", "0 hello"),
    "none": ("lambda msg: print(msg.data)", "None", "hello"),
    "bound method": ("Robot().hear", "'x'", "robot x hello"),
}


@pytest.mark.parametrize(("callback", "args", "shown"), ARGS.values(), ids=ARGS)
def test_callback_arguments(prints, sim, callback, args, shown):
    sim.rostopic_pub("/words", "std_msgs/String", "hello")
    text = f"""
        from std_msgs.msg import String
        class Robot:
            def hear(self, msg, name):
                print('robot', name, msg.data)
        rospy.init_node('x')
        rospy.Subscriber('/words', String, {callback}, callback_args={args})
        rospy.sleep(0.1)
        """
    assert prints(text) == shown + "\n"


@pytest.mark.parametrize(
    ("queue_size", "heard"), [(None, "0 1 2 3 4 5"), (1, "0 5"), (2, "0 4 5"), (-1, "0 1 2 3 4 5")]
)
def test_a_full_queue_drops_the_oldest_while_the_callback_is_busy(
    prints, partner, queue_size, heard
):
    partner(
        """
        from std_msgs.msg import Int32
        rospy.init_node('mouth')
        pub = rospy.Publisher('numbers', Int32, queue_size=10)
        rospy.sleep(0.5)
        for number in range(6):
            pub.publish(number)
            rospy.sleep(0.1)
        """
    )
    text = f"""
        from std_msgs.msg import Int32
        rospy.init_node('ear')
        heard = []
        def slow(msg):
            rospy.sleep(1)
            heard.append(msg.data)
        rospy.Subscriber('numbers', Int32, slow, queue_size={queue_size})
        rospy.sleep(9)
        print(*heard)
        """
    assert prints(text) == heard + "\n"


def test_an_unregistered_subscriber_hears_no_more(prints, sim):
    sim.rostopic_pub("/words", "std_msgs/String", "x", rate=10)
    text = """
        from std_msgs.msg import String
        rospy.init_node('x')
        heard = []
        sub = rospy.Subscriber('words', String, heard.append)
        rospy.sleep(0.35)
        sub.unregister()
        sub.unregister()
        rospy.sleep(1)
        print(len(heard))
        """
    assert prints(text) in ("3\n", "4\n")


WAITING = {
    "comes": ("rospy.wait_for_message('words', String).data", "hello"),
    "comes in time": ("rospy.wait_for_message('/words', String, timeout=5).data", "hello"),
    "does not": (
        "error_of(rospy.wait_for_message, 'silence', String, 2.5)",
        "ROSException: timeout exceeded while waiting for message on topic silence after 2.5",
    ),
}


@pytest.mark.parametrize(("expression", "shown"), WAITING.values(), ids=WAITING)
def test_waiting_for_a_message(prints, sim, expression, shown):
    sim.graph.executor.call_at(
        sim.graph.executor.now_ns + 10**9,
        lambda: sim.rostopic_pub("/words", "std_msgs/String", "hello"),
    )
    text = f"""
        from std_msgs.msg import String
        rospy.init_node('x')
        def error_of(function, *args):
            start = rospy.get_time()
            try:
                function(*args)
            except rospy.ROSException as error:
                return '%s: %s after %s' % (type(error).__name__, error, rospy.get_time() - start)
        print({expression})
        """
    assert prints(text) == shown + "\n"


def test_what_is_published_can_be_asked(prints, sim):
    sim.rosrun("turtlesim", "turtlesim_node")
    text = """
        from std_msgs.msg import String
        rospy.init_node('x')
        rospy.Subscriber('heard_only', String, print)
        pub = rospy.Publisher('words', String, queue_size=1)
        topics = rospy.get_published_topics()
        print(['/turtle1/pose', 'turtlesim/Pose'] in topics, '/heard_only' in dict(topics), '/words' in dict(topics))
        print(sorted(dict(rospy.get_published_topics('/turtle1'))))
        print(pub.name, pub.resolved_name, pub.type, pub.get_num_connections(), pub.md5sum[:4])
        """
    assert prints(text).splitlines() == [
        "True False True",
        "['/turtle1/color_sensor', '/turtle1/pose']",
        "words /words std_msgs/String 0 992c",
    ]


def test_connections_are_counted(prints, partner):
    partner(
        """
        from std_msgs.msg import String
        rospy.init_node('ear')
        rospy.Subscriber('words', String, print)
        rospy.spin()
        """
    )
    text = """
        from std_msgs.msg import String
        rospy.init_node('x')
        pub = rospy.Publisher('words', String, queue_size=1)
        while pub.get_num_connections() == 0:
            rospy.sleep(0.1)
        sub = rospy.Subscriber('words', String, lambda msg: None)
        print(pub.get_num_connections(), sub.get_num_connections())
        """
    assert prints(text) == "2 1\n"
