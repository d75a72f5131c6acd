"""What a script leaves behind in its process: threads end with what they were for."""

import pytest

from simkit import Simulation

# `_thread._count()` knows each thread besides the main one. One that has handed over for good may need a moment to end.
FEW = 5

MOUTH = """
    import rospy
    from std_msgs.msg import Int32
    rospy.init_node('mouth')
    pub = rospy.Publisher('numbers', Int32, queue_size=10)
    number = 0
    while not rospy.is_shutdown():
        number += 1
        pub.publish(number)
        rospy.sleep(0.002)
    """


@pytest.fixture
def mouth(run_script):
    """A node that says the next number on /numbers every 2 ms."""
    return run_script(MOUTH, name="mouth.py")


@pytest.mark.usefixtures("mouth")
def test_waiting_for_messages_in_a_loop_leaves_no_threads(run_script):
    node = run_script(
        """
        import _thread, rospy
        from std_msgs.msg import Int32
        rospy.init_node('patient')
        counts, numbers = [], []
        for _ in range(300):
            numbers.append(rospy.wait_for_message('numbers', Int32).data)
            counts.append(_thread._count())
        print(max(counts), len(set(numbers)), numbers == sorted(numbers))
        """,
        seconds=2,
    )
    assert node.failure is None
    most, heard, in_order = node.output.split()
    assert int(most) <= FEW
    assert (heard, in_order) == ("300", "True")


@pytest.mark.usefixtures("mouth")
def test_a_callback_may_end_its_own_subscription(run_script):
    node = run_script(
        """
        import _thread, rospy
        from std_msgs.msg import Int32
        rospy.init_node('once')
        start = rospy.get_time()
        def once(msg):
            subscriber.unregister()
            rospy.sleep(0.1)
            print('heard after', round(rospy.get_time() - start, 1))
        subscriber = rospy.Subscriber('numbers', Int32, once)
        rospy.sleep(1)
        print(subscriber.get_num_connections(), _thread._count())
        """,
        seconds=2,
    )
    assert node.failure is None
    first, second = node.output.splitlines()
    assert first == "heard after 0.1"
    connections, threads = second.split()
    assert connections == "0"
    assert int(threads) <= FEW


@pytest.mark.usefixtures("mouth")
def test_a_callback_may_subscribe_anew_each_time(run_script):
    node = run_script(
        """
        import _thread, rospy
        from std_msgs.msg import Int32
        rospy.init_node('restless')
        heard, counts = [], []
        def change(msg):
            global subscriber
            subscriber.unregister()
            subscriber = rospy.Subscriber('numbers', Int32, change)
            heard.append(msg.data)
            counts.append(_thread._count())
        subscriber = rospy.Subscriber('numbers', Int32, change)
        rospy.sleep(0.5)
        print(len(heard) > 100, heard == sorted(set(heard)), max(counts))
        """,
        seconds=1,
    )
    assert node.failure is None
    many, in_order, most = node.output.split()
    assert (many, in_order) == ("True", "True")
    assert int(most) <= FEW


@pytest.mark.usefixtures("mouth")
@pytest.mark.parametrize(
    "begin",
    [
        "ear.append(rospy.Subscriber('numbers', Int32, enough))",
        "threading.Thread(target=enough, args=(None,)).start()",
    ],
    ids=["callback", "thread"],
)
def test_a_thread_may_end_the_node_and_then_itself(run_script, begin):
    node = run_script(
        f"""
        import rospy, threading
        from std_msgs.msg import Int32
        rospy.init_node('brief')
        ear = []
        def enough(msg):
            for subscriber in ear:
                subscriber.unregister()
            rospy.signal_shutdown('enough')
        {begin}
        rospy.spin()
        threading.Event().wait(0.1)
        print('after the end')
        """,
        seconds=1,
    )
    assert node.failure is None
    assert node.exit_code == 0
    assert node.output == "after the end\n"


def test_a_service_can_be_withdrawn_and_offered_again(run_script):
    node = run_script(
        """
        import _thread, rospy
        from std_srvs.srv import Trigger
        rospy.init_node('fickle')
        call, answers, counts = rospy.ServiceProxy('again', Trigger), [], []
        for number in range(100):
            service = rospy.Service('again', Trigger, lambda request: (True, str(number)))
            answers.append(call().message)
            service.shutdown()
            counts.append(_thread._count())
        print(answers == [str(number) for number in range(100)], max(counts))
        try:
            call()
        except rospy.ServiceException as error:
            print(error)
        """,
        seconds=1,
    )
    assert node.failure is None
    first, second = node.output.splitlines()
    good, most = first.split()
    assert good == "True"
    assert int(most) <= FEW
    assert "unavailable" in second


def test_calls_that_have_come_are_answered_after_the_service_is_withdrawn(run_script):
    node = run_script(
        """
        import _thread, rospy, threading
        from std_srvs.srv import Trigger
        rospy.init_node('last_orders')
        answers = []
        def serve(request):
            service.shutdown()
            rospy.sleep(0.1)
            return True, 'served'
        service = rospy.Service('bar', Trigger, serve)
        call = rospy.ServiceProxy('bar', Trigger)
        guests = [threading.Thread(target=lambda: answers.append(call().message)) for _ in range(3)]
        for guest in guests:
            guest.start()
        for guest in guests:
            guest.join()
        print(answers, round(rospy.get_time() % 100, 1))
        rospy.sleep(0.1)
        print(_thread._count())
        """,
        seconds=2,
    )
    assert node.failure is None
    answers, threads = node.output.splitlines()
    assert answers == "['served', 'served', 'served'] 0.3"
    assert int(threads) <= FEW


COMING_AND_GOING = """
    import random, rospy
    from std_msgs.msg import Int32, String
    rospy.init_node('coming_and_going')
    pub = rospy.Publisher('/said', String, queue_size=100)
    def say(what, number):
        pub.publish('%s %d %r %r' % (what, number, rospy.get_time(), random.random()))
    def change(msg):
        global subscriber
        rospy.sleep(0.003)
        if msg.data % 3 == 0:
            subscriber.unregister()
            subscriber = rospy.Subscriber('numbers', Int32, change)
        say('heard', msg.data)
    subscriber = rospy.Subscriber('numbers', Int32, change)
    rospy.Timer(rospy.Duration(0.004), lambda event: say('timer', 0))
    while not rospy.is_shutdown():
        say('waited for', rospy.wait_for_message('numbers', Int32).data)
    """


def test_threads_that_come_and_go_give_the_same_bytes(package):
    def run():
        package("mouth.py", MOUTH)
        package("coming.py", COMING_AND_GOING)
        with Simulation(7, package_path=[package.folder], screen=None) as sim:
            record = sim.record({"/said": "std_msgs/String"})
            sim.rosrun("play", "coming.py")
            sim.rosrun("play", "mouth.py")
            sim.run(0.5)
            return record.raw("/said")

    first = run()
    assert len(first) > 200
    assert run() == first
