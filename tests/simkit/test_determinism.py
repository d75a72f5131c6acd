"""Same input, same bytes: every topic of a simulation with turtlesim, scripts, services and TF."""

import subprocess
import sys

from simkit import Simulation

BROADCASTER = """
    import random
    import rospy
    import tf
    import turtlesim.msg
    rospy.init_node('broadcaster')
    name = rospy.get_param('~turtle', 'turtle1')
    def handle(msg, turtle):
        tf.TransformBroadcaster().sendTransform(
            (msg.x + random.gauss(0, 0.01), msg.y, 0),
            tf.transformations.quaternion_from_euler(0, 0, msg.theta), rospy.Time.now(), turtle, 'world')
    rospy.Subscriber('/%s/pose' % name, turtlesim.msg.Pose, handle, name)
    rospy.spin()
    """
FOLLOWER = """
    import math
    import geometry_msgs.msg
    import rospy
    import tf
    import turtlesim.srv
    rospy.init_node('follower')
    listener = tf.TransformListener()
    rospy.wait_for_service('spawn')
    rospy.ServiceProxy('spawn', turtlesim.srv.Spawn)(4, 2, 0, 'turtle2')
    publisher = rospy.Publisher('turtle2/cmd_vel', geometry_msgs.msg.Twist, queue_size=10)
    rate = rospy.Rate(10)
    while not rospy.is_shutdown():
        try:
            (x, y, _), _ = listener.lookupTransform('/turtle2', '/turtle1', rospy.Time(0))
        except (tf.LookupException, tf.ConnectivityException, tf.ExtrapolationException):
            continue
        twist = geometry_msgs.msg.Twist()
        twist.linear.x, twist.angular.z = 0.5 * math.hypot(x, y), 4 * math.atan2(y, x)
        publisher.publish(twist)
        rate.sleep()
    """
TOPICS = {
    "/tf": "tf2_msgs/TFMessage",
    "/turtle1/pose": "turtlesim/Pose",
    "/turtle2/pose": "turtlesim/Pose",
    "/turtle2/cmd_vel": "geometry_msgs/Twist",
    "/turtle1/color_sensor": "turtlesim/Color",
}


def world(package, seed):
    """Bytes and times of every message of ten seconds, and the log."""
    package("broadcaster.py", BROADCASTER)
    package("follower.py", FOLLOWER)
    with Simulation(seed, package_path=[package.folder], screen=None) as sim:
        record = sim.record(TOPICS)
        sim.rosrun("turtlesim", "turtlesim_node")
        sim.rosrun("play", "broadcaster.py")
        sim.rosrun("play", "broadcaster.py", "_turtle:=turtle2", "__name:=second")
        sim.rosrun("play", "follower.py")
        sim.rostopic_pub(
            "/turtle1/cmd_vel", "geometry_msgs/Twist", "[[1, 0, 0], [0, 0, 0.5]]", rate=10
        )
        sim.run(10)
        return {topic: record.raw(topic) for topic in TOPICS}, [str(line) for line in sim.log]


def test_two_runs_are_the_same_bytes_also_under_load(package):
    first = world(package, 7)
    assert {topic: len(messages) > 50 for topic, messages in first[0].items()} == dict.fromkeys(
        TOPICS, True
    )
    burners = [subprocess.Popen([sys.executable, "-c", "while True: pass"]) for _ in range(4)]
    try:
        assert world(package, 7) == first
    finally:
        for burner in burners:
            burner.kill()
            burner.wait()


def test_another_seed_gives_another_world(package):
    assert world(package, 7)[0]["/tf"] != world(package, 8)[0]["/tf"]
