"""tf in scripts that run as nodes of their own."""

from __future__ import annotations

import math

import pytest

BROADCASTER = """
    import rospy, tf, turtlesim.msg

    def handle_turtle_pose(msg, turtle):
        broadcaster.sendTransform(
            (msg.x, msg.y, 0), tf.transformations.quaternion_from_euler(0, 0, msg.theta),
            rospy.Time.now(), turtle, "world")

    rospy.init_node("turtle_tf_broadcaster")
    broadcaster = tf.TransformBroadcaster()
    turtle = rospy.get_param("~turtle")
    rospy.Subscriber("/%s/pose" % turtle, turtlesim.msg.Pose, handle_turtle_pose, turtle)
    rospy.spin()
"""

FOLLOWER = """
    import math, rospy, tf, geometry_msgs.msg, turtlesim.srv

    rospy.init_node("turtle_tf_listener")
    listener = tf.TransformListener()
    rospy.wait_for_service("spawn")
    rospy.ServiceProxy("spawn", turtlesim.srv.Spawn)(4, 2, 0, "turtle2")
    command = rospy.Publisher("turtle2/cmd_vel", geometry_msgs.msg.Twist, queue_size=1)
    rate = rospy.Rate(10.0)
    while not rospy.is_shutdown():
        try:
            trans, rot = listener.lookupTransform("/turtle2", "/turtle1", rospy.Time(0))
        except (tf.LookupException, tf.ConnectivityException, tf.ExtrapolationException):
            continue
        twist = geometry_msgs.msg.Twist()
        twist.linear.x = 0.5 * math.hypot(trans[0], trans[1])
        twist.angular.z = 4 * math.atan2(trans[1], trans[0])
        command.publish(twist)
        rate.sleep()
"""


def test_a_turtle_follows_another_by_tf(sim, run_script):
    sim.rosrun("turtlesim", "turtlesim_node")
    for turtle in ("turtle1", "turtle2"):
        run_script(BROADCASTER, f"_turtle:={turtle}", f"__name:={turtle}_tf", name="broadcaster.py")
    follower = run_script(FOLLOWER, name="follower.py")
    circle = "{linear: {x: 1.0}, angular: {z: 0.5}}"
    sim.rostopic_pub("/turtle1/cmd_vel", "geometry_msgs/Twist", circle, rate=10)
    sim.run(25)
    assert follower.failure is None
    first, second = sim.latest("/turtle1/pose"), sim.latest("/turtle2/pose")
    # What real ROS settles at.
    assert math.hypot(first.x - second.x, first.y - second.y) == pytest.approx(1.508, abs=0.02)
    assert second.linear_velocity == pytest.approx(0.754, abs=0.01)
    report = sim.tf.all_frames_as_yaml()
    assert "broadcaster: '/turtle1_tf'" in report


def test_waiting_costs_virtual_time_only(sim, run_script):
    run_script(
        """
        import rospy, tf
        rospy.init_node("late")
        rospy.sleep(2.0)
        broadcaster = tf.TransformBroadcaster()
        while not rospy.is_shutdown():
            broadcaster.sendTransform((1, 2, 3), (0, 0, 0, 1), rospy.Time.now(), "a", "world")
            rospy.sleep(0.1)
        """,
        name="late.py",
    )
    node = run_script(
        """
        import rospy, tf
        rospy.init_node("waiter")
        listener = tf.TransformListener()
        start = rospy.get_time()
        try:
            listener.waitForTransform("/world", "/a", rospy.Time(0), rospy.Duration(1.0))
        except tf.Exception as error:
            print(error)
        print("%.2f" % (rospy.get_time() - start))
        listener.waitForTransform("/world", "/a", rospy.Time(0), rospy.Duration(4.0))
        print("%.2f" % (rospy.get_time() - start))
        print(listener.lookupTransform("/world", "/a", rospy.Time(0)))
        """,
        name="waiter.py",
        seconds=5.0,
    )
    assert node.output.splitlines() == [
        "canTransform: target_frame world does not exist. "
        "canTransform: source_frame a does not exist.",
        "1.00",
        "2.04",
        "([1.0, 2.0, 3.0], [0.0, 0.0, 0.0, 1.0])",
    ]


def test_what_a_broadcaster_does_wrong_is_in_the_log(sim, run_script):
    run_script(
        """
        import rospy, tf
        rospy.init_node("wrong")
        broadcaster = tf.TransformBroadcaster()
        for _ in range(3):
            broadcaster.sendTransform((0, 0, 0), (0, 0, 1.57, 0), rospy.Time.now(), "a", "world")
            rospy.sleep(0.1)
        """,
        seconds=1.0,
    )
    said = [record.text for record in sim.log if record.level.name == "WARN"]
    assert [text.split()[0] for text in said] == ["TF_DENORMALIZED_QUATERNION:", "The"]
    assert not sim.tf.can_transform("world", "a")


def test_a_slip_in_sending_is_reported_at_its_line(sim, run_script):
    node = run_script(
        """
        import rospy, tf
        rospy.init_node("slip")
        tf.TransformBroadcaster().sendTransform((0, 0, 0), (0, 0, 1.57), rospy.Time.now(), "a", "b")
        """,
        seconds=1.0,
    )
    assert node.failure.line == 3
    assert "rotation must be a quaternion (x, y, z, w), not (0, 0, 1.57)" in node.failure.text


def test_importing_the_library_alone(sim, run_script):
    node = run_script(
        """
        import tf.transformations
        from tf.transformations import euler_from_quaternion, quaternion_from_euler
        print(["%.1f" % a for a in euler_from_quaternion(quaternion_from_euler(0.1, 0.2, 0.3))])
        """,
        seconds=0.1,
    )
    assert node.output == "['0.1', '0.2', '0.3']\n"


def test_a_script_may_have_a_module_that_is_named_as_the_package_below_tf(sim, run_script, package):
    package("transformations.py", "OWN = 'mine'")
    node = run_script(
        """
        import tf, transformations
        print(transformations.OWN, len(tf.transformations.random_quaternion()))
        """,
        seconds=0.1,
    )
    assert node.output == "mine 4\n"
