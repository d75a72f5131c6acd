"""Virtual seconds per second of a crowd: ten turtles, each with a broadcaster script, nine of them following the one before."""

from __future__ import annotations

import contextlib
import tempfile
import time
from pathlib import Path

from figures import Figure, show

from simkit import Simulation

TURTLES = 10
SECONDS = 10.0
BROADCASTER = """
import rospy
import tf
import turtlesim.msg

def handle(msg, name):
    tf.TransformBroadcaster().sendTransform(
        (msg.x, msg.y, 0), tf.transformations.quaternion_from_euler(0, 0, msg.theta),
        rospy.Time.now(), name, "world")

rospy.init_node("broadcaster")
name = rospy.get_param("~turtle")
rospy.Subscriber("/%s/pose" % name, turtlesim.msg.Pose, handle, name)
rospy.spin()
"""
FOLLOWER = """
import math
import geometry_msgs.msg
import rospy
import tf

rospy.init_node("follower")
me, other = rospy.get_param("~turtle"), rospy.get_param("~other")
listener = tf.TransformListener()
publisher = rospy.Publisher(me + "/cmd_vel", geometry_msgs.msg.Twist, queue_size=1)
rate = rospy.Rate(10.0)
while not rospy.is_shutdown():
    try:
        trans, _ = listener.lookupTransform(me, other, rospy.Time(0))
    except tf.Exception:
        rate.sleep()
        continue
    twist = geometry_msgs.msg.Twist()
    twist.linear.x = 0.5 * math.hypot(trans[0], trans[1])
    twist.angular.z = 4 * math.atan2(trans[1], trans[0])
    publisher.publish(twist)
    rate.sleep()
"""


def main() -> None:
    """Print the figures."""
    with tempfile.TemporaryDirectory() as folder, contextlib.ExitStack() as stack:
        package = Path(folder) / "crowd"
        package.mkdir()
        (package / "package.xml").write_text("<package format='2'><name>crowd</name></package>")
        (package / "broadcaster.py").write_text(BROADCASTER)
        (package / "follower.py").write_text(FOLLOWER)
        sim = stack.enter_context(Simulation(package_path=[folder], screen=None))
        sim.rosrun("turtlesim", "turtlesim_node")
        for number in range(1, TURTLES + 1):
            me = f"turtle{number}"
            if number > 1:
                sim.call(
                    "/spawn",
                    x=1.0 + number % 4 * 3.0,
                    y=1.0 + number // 4 * 3.0,
                    theta=0.0,
                    name=me,
                )
                words = (
                    f"_turtle:={me}",
                    f"_other:=turtle{number - 1}",
                    f"__name:=follower_{number}",
                )
                sim.rosrun("crowd", "follower.py", *words)
            sim.rosrun("crowd", "broadcaster.py", f"_turtle:={me}", f"__name:=broadcaster_{number}")
        circle = "{linear: {x: 1.0}, angular: {z: 0.5}}"
        sim.rostopic_pub("/turtle1/cmd_vel", "geometry_msgs/Twist", circle, rate=10)
        sim.run(1.0)  # every node has started
        start = time.perf_counter()
        sim.run(SECONDS)
        speed = SECONDS / (time.perf_counter() - start)
    show(
        Figure(
            "virtual seconds per second, 10 turtles, 19 scripts",
            speed,
            "x",
            1.0,
            more_is_better=True,
        )
    )


if __name__ == "__main__":
    main()
