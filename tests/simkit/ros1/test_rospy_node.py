"""rospy: the node itself - its start, its names, its end."""

import pytest

INIT = {
    "a name": ("rospy.init_node('talker'); print(rospy.get_name())", "/talker"),
    "no name yet": ("print(rospy.get_name())", "/unnamed"),
    "namespace at root": ("rospy.init_node('talker'); print(rospy.get_namespace())", "/"),
    "caller id": ("rospy.init_node('talker'); print(rospy.get_caller_id())", "/talker"),
    "no address": ("rospy.init_node('talker'); print(rospy.get_node_uri())", "None"),
    "initialized": (
        "print(rospy.core.is_initialized()); rospy.init_node('x'); print(rospy.core.is_initialized())",
        "False\nTrue",
    ),
    "the same again": ("rospy.init_node('x'); rospy.init_node('x'); print('fine')", "fine"),
    "keywords": (
        "rospy.init_node('x', argv=None, anonymous=False, log_level=rospy.DEBUG, disable_rostime=False, "
        "disable_rosout=False, disable_signals=True, xmlrpc_port=0, tcpros_port=0); print('fine')",
        "fine",
    ),
    "anonymous": (
        "rospy.init_node('x', anonymous=True); name = rospy.get_name(); "
        "print(name.startswith('/x_') and len(name) > 3)",
        "True",
    ),
    "star import": (
        "from rospy import *; init_node('x'); print(get_name(), Rate.__name__)",
        "/x Rate",
    ),
    "client module": ("from rospy.client import init_node; init_node('x'); print('fine')", "fine"),
    "submodules": (
        "import rospy.exceptions, rospy.rostime, rospy.core, rospy.timer, rospy.topics\n"
        "from rospy.exceptions import ROSInterruptException\n"
        "from rospy.rostime import Duration, Time\n"
        "from rospy.service import ServiceException\n"
        "print(Time is rospy.Time, ServiceException is rospy.ServiceException)",
        "True True",
    ),
    "myargv": (
        "import sys; print(rospy.myargv(argv=['x.py', 'a:=b', '_p:=1', '__name:=n', 'own', '-v']))",
        "['x.py', 'own', '-v']",
    ),
}


@pytest.mark.parametrize(("text", "shown"), INIT.values(), ids=INIT)
def test_beginnings(prints, text, shown):
    assert prints(text).strip() == shown


WRONG = {
    "empty": ("rospy.init_node('')", "ValueError: name must not be empty"),
    "none": ("rospy.init_node(None)", "ValueError: name must not be empty"),
    "namespace": (
        "rospy.init_node('/talker')",
        "ValueError: namespaces are not allowed in node names",
    ),
    "illegal": ("rospy.init_node('1st')", "ROSException: init_node: '1st' is not a node name"),
    "other name": (
        "rospy.init_node('a'); rospy.init_node('b')",
        "ROSException: rospy.init_node() has already been called with different arguments",
    ),
    "nothing": ("rospy.init_node()", "TypeError"),
    "spin": ("rospy.spin()", "ROSInitException: client code must call rospy.init_node() first"),
    "now": (
        "rospy.Time.now()",
        "ROSInitException: time is not initialized. Have you called init_node()?",
    ),
    "get_time": ("rospy.get_time()", "ROSInitException: time is not initialized"),
    "rate": ("rospy.Rate(10)", "ROSInitException: time is not initialized"),
    "sleep": ("rospy.sleep(1)", "ROSInitException"),
    "timer": ("rospy.Timer(rospy.Duration(1), print)", "ROSInitException"),
    "hook": (
        "rospy.init_node('x'); rospy.on_shutdown('goodbye')",
        "TypeError: shutdown hook [goodbye] must be a function or callable object: <class 'str'>",
    ),
}


@pytest.mark.parametrize(("text", "error"), WRONG.values(), ids=WRONG)
def test_what_cannot_begin_is_an_error_at_its_line(run_script, text, error):
    node = run_script(f"import rospy\n{text}\n", seconds=0.1)
    assert error in node.failure.text
    assert node.failure.line == 2
    assert node.exit_code == 1


NAMES = {
    "relative": ("chatter", "/left/chatter"),
    "global": ("/chatter", "/chatter"),
    "private": ("~gain", "/left/arm/gain"),
    "remapped": ("pose", "/elsewhere"),
    "remapped global": ("/left/pose", "/elsewhere"),
}


@pytest.mark.parametrize(("name", "resolved"), NAMES.values(), ids=NAMES)
def test_names_resolve_in_the_nodes_namespace(prints, name, resolved):
    text = f"""
        rospy.init_node('anything')
        print(rospy.get_name(), rospy.get_namespace(), rospy.resolve_name({name!r}))
        """
    arguments = ("__ns:=left", "__name:=arm", "pose:=/elsewhere")
    assert prints(text, *arguments) == f"/left/arm /left/ {resolved}\n"


def test_hooks_run_in_order_once_and_can_still_sleep_and_publish(prints, sim):
    record = sim.record({"/cmd_vel": "geometry_msgs/Twist"})
    output = prints(
        """
        from geometry_msgs.msg import Twist
        rospy.init_node('robot')
        cmd_vel = rospy.Publisher('/cmd_vel', Twist, queue_size=1)
        def stop():
            print('stopping', rospy.is_shutdown(), rospy.core.is_shutdown_requested())
            cmd_vel.publish(Twist())
            start = rospy.get_time()
            rospy.sleep(1)
            print('stopped after', rospy.get_time() - start)
        rospy.on_shutdown(stop)
        rospy.on_shutdown(lambda: print('second'))
        rospy.signal_shutdown('enough')
        rospy.signal_shutdown('again')
        print(rospy.is_shutdown())
        rospy.on_shutdown(lambda: print('late'))
        """
    )
    assert output == "stopping False True\nstopped after 1.0\nsecond\nTrue\nlate\n"
    assert len(record["/cmd_vel"]) == 1


def test_hooks_run_at_the_end_of_the_script_too(prints):
    text = "rospy.init_node('x'); rospy.on_shutdown(lambda: print('goodbye')); print('end')"
    assert prints(text) == "end\ngoodbye\n"


@pytest.mark.parametrize("wait", ["rospy.spin()", "rospy.sleep(100)", "rospy.Rate(0.01).sleep()"])
def test_a_shutdown_from_outside_runs_hooks_that_may_sleep_and_ends_waits(sim, run_script, wait):
    node = run_script(
        f"""
        import rospy
        rospy.init_node('robot')
        rospy.on_shutdown(lambda: (rospy.sleep(1.0), print('parked')))
        try:
            {wait}
        except rospy.ROSInterruptException as error:
            print(type(error).__name__, error)
        """,
        seconds=1.0,
    )
    node.shutdown()
    sim.run(0.5)
    assert node.alive
    sim.run(1.0)
    assert not node.alive
    assert node.failure is None
    text = "ROSInterruptException ROS shutdown request\n" if "spin" not in wait else ""
    assert node.output == "parked\n" + text


def test_an_interrupt_may_be_caught_as_keyboard_interrupt_or_not_at_all(sim, run_script):
    nodes = [
        run_script(f"import rospy\nrospy.init_node('n{i}')\n{text}", name=f"n{i}.py", seconds=0.1)
        for i, text in enumerate(
            (
                "try:\n    rospy.sleep(100)\nexcept KeyboardInterrupt:\n    print('caught')",
                "try:\n    rospy.sleep(100)\nexcept rospy.ROSException:\n    print('caught')",
                "rospy.sleep(100)",
                "while not rospy.is_shutdown():\n    rospy.sleep(0.1)",
            )
        )
    ]
    for node in nodes:
        node.shutdown()
    sim.run(1)
    assert [node.output for node in nodes] == ["caught\n", "caught\n", "", ""]
    assert [(node.failure, node.exit_code) for node in nodes] == [(None, 0)] * 4


def test_a_callback_whose_sleep_the_shutdown_ends_is_no_fault(sim, run_script):
    node = run_script(
        """
        import rospy
        from std_msgs.msg import Empty
        rospy.init_node('slow')
        rospy.Subscriber('go', Empty, lambda _: rospy.sleep(100))
        rospy.Timer(rospy.Duration(0.1), lambda _: rospy.sleep(100))
        rospy.spin()
        """
    )
    sim.rostopic_pub("/go", "std_msgs/Empty")
    sim.run(1)
    node.shutdown()
    sim.run(1)
    assert not node.alive
    assert node.failure is None
    assert not any("bad callback" in record.text for record in sim.log)


def test_a_hook_that_fails_keeps_no_other_from_running(sim, run_script):
    node = run_script(
        """
        import rospy
        rospy.init_node('x')
        def bad():
            1 / 0
        rospy.on_shutdown(bad)
        rospy.on_shutdown(lambda: print('still here'))
        """,
        seconds=0.1,
    )
    assert "still here\n" in node.output
    assert "ZeroDivisionError" in node.output
    assert (node.failure.line, node.failure.function) == (4, "bad")


def test_the_new_node_of_a_name_ends_the_old_one_in_its_sleep(sim, partner):
    text = """
        rospy.init_node('twin')
        rospy.on_shutdown(lambda: print('goodbye'))
        while not rospy.is_shutdown():
            rospy.sleep(0.1)
        """
    old = partner(text, name="old.py")
    sim.run(1)
    new = partner(text, name="new.py")
    sim.run(1)
    assert (old.alive, new.alive) == (False, True)
    assert (old.output, old.exit_code, old.failure) == ("goodbye\n", 0, None)
