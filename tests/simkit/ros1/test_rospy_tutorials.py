"""What the tutorials of ROS teach, in our own words: programs of the kinds that every course has."""

import math

import pytest


def test_talker_and_listener(sim, partner, run_script):
    talker = partner(
        """
        from std_msgs.msg import String

        def talker():
            pub = rospy.Publisher('chatter', String, queue_size=10)
            rospy.init_node('talker', anonymous=True)
            rate = rospy.Rate(10)
            while not rospy.is_shutdown():
                hello_str = "hello world %s" % rospy.get_time()
                rospy.loginfo(hello_str)
                pub.publish(hello_str)
                rate.sleep()

        if __name__ == '__main__':
            try:
                talker()
            except rospy.ROSInterruptException:
                pass
        """,
        name="talker.py",
    )
    listener = partner(
        """
        from std_msgs.msg import String

        def callback(data):
            rospy.loginfo(rospy.get_caller_id() + " I heard %s", data.data)

        def listener():
            rospy.init_node('listener', anonymous=True)
            rospy.Subscriber("chatter", String, callback)
            rospy.spin()

        if __name__ == '__main__':
            listener()
        """,
        name="listener.py",
    )
    sim.run(1.05)
    said = [r.text for r in sim.log if r.node == talker.name]
    heard = [r.text for r in sim.log if r.node == listener.name]
    assert len(said) == 11
    # The first word is said before anybody listens.
    assert heard == [f"{listener.name} I heard {text}" for text in said[1:]]
    for node in (talker, listener):
        node.shutdown()
    sim.run(1)
    assert [(node.alive, node.exit_code, node.failure) for node in (talker, listener)] == [
        (False, 0, None)
    ] * 2


def test_a_service_that_adds(prints, partner):
    partner(
        """
        from rospy_tutorials.srv import AddTwoInts, AddTwoIntsResponse

        def handle_add_two_ints(req):
            print("Returning [%s + %s = %s]" % (req.a, req.b, req.a + req.b))
            return AddTwoIntsResponse(req.a + req.b)

        def add_two_ints_server():
            rospy.init_node('add_two_ints_server')
            s = rospy.Service('add_two_ints', AddTwoInts, handle_add_two_ints)
            rospy.spin()

        if __name__ == "__main__":
            add_two_ints_server()
        """
    )
    client = """
        import sys
        from rospy_tutorials.srv import *

        def add_two_ints_client(x, y):
            rospy.wait_for_service('add_two_ints')
            try:
                add_two_ints = rospy.ServiceProxy('add_two_ints', AddTwoInts)
                return add_two_ints(x, y).sum
            except rospy.ServiceException as e:
                print("Service call failed: %s" % e)

        if __name__ == "__main__":
            if len(sys.argv) == 3:
                x, y = int(sys.argv[1]), int(sys.argv[2])
            else:
                sys.exit(1)
            rospy.init_node('client')
            print("%s + %s = %s" % (x, y, add_two_ints_client(x, y)))
        """
    assert prints(client, "40", "2") == "40 + 2 = 42\n"


GO_TO_GOAL = """
    from math import atan2, pow, sqrt
    from geometry_msgs.msg import Twist
    from turtlesim.msg import Pose

    class TurtleBot:

        def __init__(self):
            rospy.init_node('turtlebot_controller', anonymous=True)
            self.velocity_publisher = rospy.Publisher('/turtle1/cmd_vel', Twist, queue_size=10)
            self.pose_subscriber = rospy.Subscriber('/turtle1/pose', Pose, self.update_pose)
            self.pose = Pose()
            self.rate = rospy.Rate(10)

        def update_pose(self, data):
            self.pose = data
            self.pose.x = round(self.pose.x, 4)
            self.pose.y = round(self.pose.y, 4)

        def distance(self, goal):
            return sqrt(pow(goal.x - self.pose.x, 2) + pow(goal.y - self.pose.y, 2))

        def steering(self, goal):
            return atan2(goal.y - self.pose.y, goal.x - self.pose.x)

        def move2goal(self, x, y, tolerance):
            goal = Pose(x=x, y=y)
            vel_msg = Twist()
            while self.distance(goal) >= tolerance:
                vel_msg.linear.x = 1.5 * self.distance(goal)
                vel_msg.angular.z = 6 * (self.steering(goal) - self.pose.theta)
                self.velocity_publisher.publish(vel_msg)
                self.rate.sleep()
            vel_msg.linear.x = 0
            vel_msg.angular.z = 0
            self.velocity_publisher.publish(vel_msg)

    bot = TurtleBot()
    bot.rate.sleep()
    bot.move2goal(GOAL, 0.1)
    """


@pytest.mark.parametrize("goal", [(9.0, 9.0), (8.0, 3.0), (2.0, 8.0)])
def test_a_turtle_goes_to_a_goal(sim, partner, goal):
    sim.rosrun("turtlesim", "turtlesim_node")
    node = partner(GO_TO_GOAL.replace("GOAL", f"{goal[0]}, {goal[1]}"))
    assert sim.run_until(lambda: not node.alive, timeout=30)
    assert (node.failure, node.exit_code) == (None, 0)
    sim.run(1)
    pose = sim.latest("/turtle1/pose")
    assert math.dist((pose.x, pose.y), goal) < 0.3
    assert pose.linear_velocity == 0


def test_a_turtle_moves_in_a_straight_line_by_watching_the_clock(sim, partner):
    sim.rosrun("turtlesim", "turtlesim_node")
    node = partner(
        """
        from geometry_msgs.msg import Twist

        def move(speed, distance):
            rospy.init_node('robot_cleaner', anonymous=True)
            velocity_publisher = rospy.Publisher('/turtle1/cmd_vel', Twist, queue_size=10)
            vel_msg = Twist()
            vel_msg.linear.x = abs(speed)
            t0 = rospy.Time.now().to_sec()
            current_distance = 0
            while current_distance < distance:
                velocity_publisher.publish(vel_msg)
                t1 = rospy.Time.now().to_sec()
                current_distance = speed * (t1 - t0)
            vel_msg.linear.x = 0
            velocity_publisher.publish(vel_msg)

        move(2.0, 3.0)
        """
    )
    assert sim.run_until(lambda: not node.alive, timeout=10)
    sim.run(1)
    assert (node.failure, node.exit_code) == (None, 0)
    assert sim.latest("/turtle1/pose").x == pytest.approx(5.544 + 3.0, abs=0.1)


def test_a_turtle_turns_by_watching_the_clock(sim, partner):
    sim.rosrun("turtlesim", "turtlesim_node")
    node = partner(
        """
        from geometry_msgs.msg import Twist
        PI = 3.1415926535897
        rospy.init_node('turner')
        publisher = rospy.Publisher('/turtle1/cmd_vel', Twist, queue_size=10)
        vel_msg, angular_speed, relative_angle = Twist(), 45 * 2 * PI / 360, 90 * 2 * PI / 360
        vel_msg.angular.z = -abs(angular_speed)
        t0 = rospy.Time.now().to_sec()
        current_angle = 0
        while current_angle < relative_angle:
            publisher.publish(vel_msg)
            t1 = rospy.Time.now().to_sec()
            current_angle = angular_speed * (t1 - t0)
        vel_msg.angular.z = 0
        publisher.publish(vel_msg)
        rospy.spin()
        """
    )
    sim.run(4)
    assert node.alive
    assert sim.latest("/turtle1/pose").theta == pytest.approx(-math.pi / 2, abs=0.05)


def test_a_robot_that_stops_when_it_is_shut_down(sim, partner):
    sim.rosrun("turtlesim", "turtlesim_node")
    node = partner(
        """
        from geometry_msgs.msg import Twist

        class Out():
            def __init__(self):
                rospy.init_node('out', anonymous=False)
                rospy.on_shutdown(self.shutdown)
                self.cmd_vel = rospy.Publisher('/turtle1/cmd_vel', Twist, queue_size=1)
                twist = Twist()
                twist.linear.x = 1
                r = rospy.Rate(50)
                while not rospy.is_shutdown():
                    self.cmd_vel.publish(twist)
                    r.sleep()

            def shutdown(self):
                rospy.loginfo("Stopping the robot...")
                self.cmd_vel.publish(Twist())
                rospy.sleep(1)

        if __name__ == '__main__':
            try:
                Out()
            except rospy.ROSInterruptException:
                rospy.loginfo("finished")
        """
    )
    sim.run(1)
    node.shutdown()
    sim.run(2)
    assert (node.alive, node.failure, node.exit_code) == (False, None, 0)
    assert any(record.text == "Stopping the robot..." for record in sim.log)


def test_a_state_machine_with_a_timer_and_a_subscriber(prints, sim):
    sim.rosrun("turtlesim", "turtlesim_node")
    text = """
        import random, threading
        from turtlesim.msg import Pose
        from turtlesim.srv import Spawn, Kill, TeleportAbsolute, SetPen

        class Guard:
            def __init__(self):
                self.lock = threading.Lock()
                self.poses = 0
                self.timer = rospy.Timer(rospy.Duration(1.0), self.report)
                self.sub = rospy.Subscriber('turtle1/pose', Pose, self.hear)
            def hear(self, msg):
                with self.lock:
                    self.poses += 1
            def report(self, event):
                with self.lock:
                    rospy.loginfo('%d poses', self.poses)

        rospy.init_node('guard')
        guard = Guard()
        rospy.wait_for_service('spawn')
        name = rospy.ServiceProxy('spawn', Spawn)(2, 2, 0, 'prey').name
        rospy.ServiceProxy('turtle1/teleport_absolute', TeleportAbsolute)(1, 1, 0)
        rospy.ServiceProxy('turtle1/set_pen', SetPen)(255, 0, 0, 3, 0)
        rospy.sleep(2.5)
        rospy.ServiceProxy('kill', Kill)(name)
        guard.timer.shutdown()
        print(name, guard.poses > 150)
        """
    assert prints(text) == "prey True\n"
    assert sum("poses" in record.text for record in sim.log) == 2
