"""tf2_ros in scripts that run as nodes of their own: what published tutorials do, in our words."""

from __future__ import annotations

import math

import pytest

POSE_BROADCASTER = """
    import rospy
    import tf2_ros
    import tf_conversions
    from geometry_msgs.msg import Quaternion, TransformStamped
    from turtlesim.msg import Pose

    def on_pose(pose, turtle):
        placed = TransformStamped()
        placed.header.stamp = rospy.Time.now()
        placed.header.frame_id = "world"
        placed.child_frame_id = turtle
        placed.transform.translation.x = pose.x
        placed.transform.translation.y = pose.y
        q = tf_conversions.transformations.quaternion_from_euler(0, 0, pose.theta)
        placed.transform.rotation = Quaternion(*q)
        tf2_ros.TransformBroadcaster().sendTransform(placed)  # a new one each time, as many do

    rospy.init_node("pose_broadcaster")
    turtle = rospy.get_param("~turtle")
    rospy.Subscriber("/%s/pose" % turtle, Pose, on_pose, turtle)
    rospy.spin()
"""

FOLLOWER = """
    import math
    import rospy
    import tf2_ros
    from geometry_msgs.msg import Twist
    from turtlesim.srv import Spawn

    rospy.init_node("follower")
    buffer = tf2_ros.Buffer()
    tf2_ros.TransformListener(buffer)  # held by nobody, as in many scripts
    rospy.wait_for_service("spawn")
    rospy.ServiceProxy("spawn", Spawn)(4, 2, 0, "turtle2")
    command = rospy.Publisher("turtle2/cmd_vel", Twist, queue_size=1)
    rate = rospy.Rate(10.0)
    while not rospy.is_shutdown():
        try:
            seen = buffer.lookup_transform("turtle2", "LEADER", rospy.Time())
        except (tf2_ros.LookupException, tf2_ros.ConnectivityException,
                tf2_ros.ExtrapolationException):
            rate.sleep()
            continue
        x, y = seen.transform.translation.x, seen.transform.translation.y
        order = Twist()
        order.linear.x = 0.5 * math.hypot(x, y)
        order.angular.z = 4 * math.atan2(y, x)
        command.publish(order)
        rate.sleep()
"""

CARROT = """
    import math
    import rospy
    import tf2_ros
    import tf2_msgs.msg
    import geometry_msgs.msg

    rospy.init_node("carrot")
    talker = rospy.Publisher("/tf", tf2_msgs.msg.TFMessage, queue_size=1)
    while not rospy.is_shutdown():
        rospy.sleep(0.1)
        t = geometry_msgs.msg.TransformStamped()
        t.header.frame_id = "turtle1"
        t.header.stamp = rospy.Time.now()
        t.child_frame_id = "carrot1"
        angle = MOVES * rospy.Time.now().to_sec()
        t.transform.translation.x = 2.0 * math.cos(angle)
        t.transform.translation.y = 2.0 * math.sin(angle)
        t.transform.rotation.w = 1.0
        talker.publish(tf2_msgs.msg.TFMessage([t]))
"""


@pytest.fixture
def turtles(sim, run_script):
    """Two turtles, broadcast; turtle1 drives a circle of radius 2 m."""
    sim.rosrun("turtlesim", "turtlesim_node")
    for turtle in ("turtle1", "turtle2"):
        run_script(POSE_BROADCASTER, f"_turtle:={turtle}", f"__name:={turtle}_tf", name="b.py")
    circle = "{linear: {x: 1.0}, angular: {z: 0.5}}"
    sim.rostopic_pub("/turtle1/cmd_vel", "geometry_msgs/Twist", circle, rate=10)
    return sim


def test_a_turtle_follows_another(turtles, run_script):
    follower = run_script(FOLLOWER.replace("LEADER", "turtle1"), name="follower.py", seconds=25)
    assert follower.failure is None
    first, second = turtles.latest("/turtle1/pose"), turtles.latest("/turtle2/pose")
    # What real ROS settles at.
    assert math.hypot(first.x - second.x, first.y - second.y) == pytest.approx(1.508, abs=0.02)
    assert second.linear_velocity == pytest.approx(0.754, abs=0.01)


@pytest.mark.parametrize("moves", ["0.0", "math.pi"])
def test_a_turtle_follows_a_carrot(turtles, run_script, moves):
    run_script(CARROT.replace("MOVES", moves), name="carrot.py")
    follower = run_script(FOLLOWER.replace("LEADER", "carrot1"), name="follower.py", seconds=5)
    assert follower.failure is None
    carrot = turtles.tf.lookup_transform("turtle1", "carrot1").transform.translation
    assert math.hypot(carrot.x, carrot.y) == pytest.approx(2.0)
    assert turtles.latest("/turtle2/pose").linear_velocity > 0.0


def test_time_travel_with_the_full_lookup(turtles, run_script):
    script = FOLLOWER.replace(
        'buffer.lookup_transform("turtle2", "LEADER", rospy.Time())',
        'buffer.lookup_transform_full("turtle2", rospy.Time.now(), "turtle1", '
        'rospy.Time.now() - rospy.Duration(5.0), "world", rospy.Duration(1.0))',
    )
    follower = run_script(script, name="time_travel.py", seconds=30)
    assert follower.failure is None
    first, second = turtles.latest("/turtle1/pose"), turtles.latest("/turtle2/pose")
    # What real ROS settles at.
    assert math.hypot(first.x - second.x, first.y - second.y) == pytest.approx(3.49, abs=0.03)


STATIC = """
    import rospy, sys, tf, tf2_ros
    from geometry_msgs.msg import TransformStamped

    def placed(name, x):
        t = TransformStamped()
        t.header.stamp = rospy.Time.now()
        t.header.frame_id = "world"
        t.child_frame_id = name
        t.transform.translation.x = x
        q = tf.transformations.quaternion_from_euler(0, 0, 0)
        (t.transform.rotation.x, t.transform.rotation.y,
         t.transform.rotation.z, t.transform.rotation.w) = q
        return t

    rospy.init_node("fixed")
    broadcaster = tf2_ros.StaticTransformBroadcaster()
    HOW
    rospy.spin()
"""
LATE_LISTENER = """
    import rospy, tf2_ros
    rospy.init_node("late")
    buffer = tf2_ros.Buffer()
    listener = tf2_ros.TransformListener(buffer)
    rospy.sleep(0.1)
    for name in ("desk", "lamp"):
        print(name, buffer.can_transform("world", name, rospy.Time.now()))
"""


@pytest.mark.parametrize(
    ("how", "heard", "warned"),
    [
        ('broadcaster.sendTransform([placed("desk", 1), placed("lamp", 2)])', [1, 1], 0),
        (
            'broadcaster.sendTransform(placed("desk", 1)); '
            'broadcaster.sendTransform(placed("lamp", 2))',
            [0, 1],
            1,
        ),
        ('[broadcaster.sendTransform(placed("desk", x)) for x in (1, 2)]', [1, 0], 0),
    ],
)
def test_what_a_static_broadcaster_keeps_for_those_who_come_later(
    sim, run_script, how, heard, warned
):
    run_script(STATIC.replace("HOW", how), name="fixed.py", seconds=1.0)
    late = run_script(LATE_LISTENER, name="late.py", seconds=1.0)
    assert late.output.split() == ["desk", str(heard[0]), "lamp", str(heard[1])]
    warnings = [record.text for record in sim.log if record.level.name == "WARN"]
    assert len(warnings) == warned
    assert all("will not hear of desk" in text for text in warnings)


LISTENER = """
    import rospy, tf2_ros
    rospy.init_node("asks")
    buffer = tf2_ros.Buffer(rospy.Duration(20.0))
    listener = tf2_ros.TransformListener(buffer)
    start = rospy.get_time()
    ASK
"""


@pytest.fixture
def ask(sim, run_script):
    """Output and handle of a listener that asks; /tf carries world -> a, 10 times a second from 2 s on."""
    run_script(
        """
        import rospy, tf2_ros
        from geometry_msgs.msg import TransformStamped
        rospy.init_node("late_broadcaster")
        rospy.sleep(2.0)
        while not rospy.is_shutdown():
            t = TransformStamped()
            t.header.stamp, t.header.frame_id, t.child_frame_id = rospy.Time.now(), "world", "a"
            t.transform.rotation.w = 1.0
            t.transform.translation.x = 3.0
            tf2_ros.TransformBroadcaster().sendTransform([t])
            rospy.sleep(0.1)
        """,
        name="late_broadcaster.py",
    )

    def run(text, seconds=6.0):
        return run_script(LISTENER.replace("ASK", text), name="asks.py", seconds=seconds)

    return run


def test_a_timeout_waits_in_virtual_time(ask):
    node = ask(
        'print(buffer.lookup_transform("world", "a", rospy.Time(0), rospy.Duration(4.0))'
        ".transform.translation.x, round(rospy.get_time() - start, 2))"
    )
    assert node.output == "3.0 2.04\n"


def test_a_timeout_that_runs_out(ask):
    node = ask(
        'print(buffer.can_transform("world", "a", rospy.Time(0), rospy.Duration(1.0), True));'
        "print(round(rospy.get_time() - start, 2));"
        'buffer.lookup_transform("world", "a", rospy.Time(0), rospy.Duration(0.5))'
    )
    reason = (
        "canTransform: target_frame world does not exist. "
        "canTransform: source_frame a does not exist."
    )
    assert node.output.splitlines()[:2] == [str((0, reason)), "1.0"]
    assert node.failure.text.startswith("simkit.tf.errors.LookupException") or (
        "LookupException" in node.failure.text
    )
    assert node.failure.text.splitlines()[-1].startswith("hint: No transform has arrived yet.")
    assert node.output.splitlines()[-1] == node.failure.text.splitlines()[-1]


def test_a_lookup_in_a_bare_loop_lets_time_pass(ask):
    node = ask(
        """
    while True:
        try:
            buffer.lookup_transform("world", "a", rospy.Time(0))
            break
        except tf2_ros.TransformException:
            continue
    print(round(rospy.get_time() - start, 2))"""
    )
    assert node.output == "2.0\n"


@pytest.mark.parametrize(
    ("question", "error", "text"),
    [
        (
            'buffer.lookup_transform("/world", "a", rospy.Time(0))',
            "InvalidArgumentException",
            'hint: Write "world"',
        ),
        (
            'buffer.lookup_transform("world", "a", rospy.Time.now())',
            "ExtrapolationException",
            "hint: The newest transform",
        ),
        (
            'buffer.lookup_transform("world", "a", rospy.Time.now() - rospy.Duration(3))',
            "ExtrapolationException",
            "hint: The buffer knows",
        ),
        (
            'buffer.lookup_transform("world", "aa", rospy.Time(0))',
            "LookupException",
            'hint: No transform named the frame "aa"',
        ),
        (
            'buffer.lookup_transform("world", "a", 0.0)',
            "TypeError",
            "time must have a to_sec method, e.g. rospy.Time or rospy.Duration",
        ),
        (
            'buffer.lookup_transform("world", "a", rospy.Time(0), 1.0)',
            "TypeError",
            "timeout must be a rospy.Duration, not 1.0",
        ),
        (
            'buffer.lookup_transform("world", rospy.Time(0), "a")',
            "TypeError",
            "frame 2 must be str, not Time",
        ),
        (
            "tf2_ros.TransformBroadcaster().sendTransform((1, 2, 3), (0, 0, 0, 1), 0, 'a', 'b')",
            "TypeError",
            "positional arguments",
        ),
        (
            "tf2_ros.TransformBroadcaster().sendTransform((1, 2, 3))",
            "TypeError",
            "takes a geometry_msgs.msg.TransformStamped, or a list of them, not tuple",
        ),
        (
            "import geometry_msgs.msg; p = geometry_msgs.msg.PointStamped();"
            ' p.header.frame_id = "a"; buffer.transform(p, "world")',
            "TypeException",
            "hint: Write `import tf2_geometry_msgs`",
        ),
    ],
)
def test_what_fails_says_why(ask, question, error, text):
    node = ask(f"rospy.sleep(3.04); {question}")
    assert error in node.failure.text
    assert text in node.failure.text
    assert node.failure.line == 6
    assert text in node.output


def test_a_name_with_a_slash_is_warned_of_once(sim, ask):
    node = ask('print(buffer.can_transform("/world", "a", rospy.Time(0), rospy.Duration(1.0)))')
    assert node.output == "0\n"
    warnings = [record.text for record in sim.log if record.level.name == "WARN"]
    assert len(warnings) == 1
    assert "frame_ids cannot start with a '/' like: " in warnings[0]


def test_stamped_messages_are_transformed(ask):
    node = ask(
        """
    import tf2_geometry_msgs
    from geometry_msgs.msg import PointStamped, PoseStamped, Vector3Stamped
    for made, part in ((PointStamped, "point"), (Vector3Stamped, "vector")):
        message = made()
        message.header.frame_id = "a"
        getattr(message, part).x = 2.0
        moved = buffer.transform(message, "world", rospy.Duration(4.0))
        print(moved.header.frame_id, getattr(moved, part).x)
    pose = PoseStamped()
    pose.header.frame_id = "a"
    pose.pose.orientation.w = 1.0
    moved = buffer.transform_full(pose, "world", rospy.Time(0), "world", new_type=PoseStamped)
    print(moved.pose.position.x, moved.pose.orientation.w)"""
    )
    assert node.output.split() == ["world", "5.0", "world", "2.0", "3.0", "1.0"]


def test_the_names_of_tf_and_tf2_are_one(ask):
    node = ask(
        """
    import tf, tf2_py
    from tf2_ros.buffer_interface import TransformRegistration
    from tf2_ros.transform_listener import TransformListener
    print(tf.LookupException is tf2_ros.LookupException is tf2_py.LookupException)
    print(tf.Exception is tf2_ros.TransformException)
    print(issubclass(tf2_ros.Buffer, tf2_py.BufferCore), tf2_ros.BufferCore is tf2_py.BufferCore)
    rospy.sleep(2.5)
    print(buffer.all_frames_as_string(), end="")
    print(buffer._frameExists("world"), buffer._getFrameStrings())
    print(buffer.get_latest_common_time("world", "a").__class__ is rospy.Time)
    print("broadcaster: '/late_broadcaster'" in buffer.all_frames_as_yaml())
    listener.unregister()
    buffer.clear()
    print(buffer.can_transform_core("world", "a", rospy.Time(0))[0])"""
    )
    assert node.output.splitlines() == [
        "True",
        "True",
        "True True",
        "Frame a exists with parent world.",
        "True ['a', 'world']",
        "True",
        "True",
        "0",
    ]


@pytest.mark.parametrize(
    ("wait", "text"),
    [
        ("waitForTransform('world', 'b', rospy.Time(0), rospy.Duration(1))", "the frame"),
        (
            "waitForTransformFull('a', rospy.Time(1), 'a', rospy.Time(1), 'world', rospy.Duration(1))",
            "one stamp is wall-clock time",
        ),
    ],
)
def test_a_wait_of_tf_that_runs_out_has_a_hint_too(ask, wait, text):
    node = ask(f"import tf; rospy.sleep(3); l = tf.TransformListener(); rospy.sleep(1); l.{wait}")
    assert node.failure.text.splitlines()[-1].startswith("hint: ")
    assert text in node.failure.text


def test_a_callback_that_fails_is_logged_with_the_hint(sim, run_script):
    node = run_script(
        """
        import rospy, tf2_ros
        from turtlesim.msg import Pose

        def on_pose(pose):
            buffer.lookup_transform("world", "turtle1", rospy.Time(0))

        rospy.init_node("asks")
        buffer = tf2_ros.Buffer()
        rospy.Subscriber("/turtle1/pose", Pose, on_pose)
        rospy.spin()
        """,
        seconds=0.1,
    )
    sim.rosrun("turtlesim", "turtlesim_node")
    sim.run(0.1)
    said = [record.text for record in sim.log if record.text.startswith("bad callback")]
    assert said
    assert said[0].splitlines()[-1].startswith("hint: No transform has arrived yet.")
    assert node.failure.line == 5
