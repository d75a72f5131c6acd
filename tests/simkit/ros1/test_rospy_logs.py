"""rospy: log calls."""

import pytest

CALLS = {
    "plain": ("rospy.loginfo('hello')", ["INFO hello"]),
    "format": ("rospy.loginfo('%s is %d', 'x', 5)", ["INFO x is 5"]),
    "format by name": ("rospy.loginfo('%(a)s', {'a': 1})", ["INFO 1"]),
    "percent without arguments": ("rospy.loginfo('100%')", ["INFO 100%"]),
    "an object": ("rospy.loginfo([1, 2])", ["INFO [1, 2]"]),
    "a message": (
        "import std_msgs.msg; rospy.loginfo(std_msgs.msg.String('x'))",
        ['INFO data: "x"'],
    ),
    "levels": (
        "rospy.logdebug('d'); rospy.loginfo('i'); rospy.logwarn('w'); rospy.logerr('e'); rospy.logfatal('f')",
        ["INFO i", "WARN w", "ERROR e", "FATAL f"],
    ),
    "old names": ("rospy.logout('o'); rospy.logerror('e')", ["INFO o", "ERROR e"]),
    "named logger": ("rospy.loginfo('hello', logger_name='part')", ["INFO hello"]),
    "once": (
        "for i in range(3): rospy.logwarn_once('once')\nrospy.logwarn_once('other place')",
        ["WARN once", "WARN other place"],
    ),
    "throttled": (
        "for i in range(10): rospy.loginfo_throttle(0.25, 'tick %d' % i); rospy.sleep(0.1)",
        ["INFO tick 0", "INFO tick 3", "INFO tick 6", "INFO tick 9"],
    ),
    "throttled exactly": (
        "for i in range(7): rospy.loginfo_throttle(0.5, i); rospy.sleep(0.25)",
        ["INFO 0", "INFO 3", "INFO 6"],
    ),
    "throttled by place": (
        "for i in range(2):\n    rospy.logerr_throttle(9, 'a')\n    rospy.logerr_throttle(9, 'b')",
        ["ERROR a", "ERROR b"],
    ),
    "throttled if identical": (
        "for text in 'aabba': rospy.logwarn_throttle_identical(60, text)",
        ["WARN a", "WARN b", "WARN a"],
    ),
    "not ascii": ("rospy.loginfo('grün 🐢')", ["INFO grün 🐢"]),
}


@pytest.mark.parametrize(("text", "said"), CALLS.values(), ids=CALLS)
def test_calls(prints, sim, text, said):
    output = prints(f"rospy.init_node('x')\n{text}")
    assert [f"{r.level.name} {r.text}" for r in sim.log if r.node == "/x"] == said
    assert output == ""


def test_the_level_of_init_node_is_the_threshold(prints, sim):
    prints("rospy.init_node('x', log_level=rospy.DEBUG)\nrospy.logdebug('seen')")
    prints(
        "rospy.init_node('y', log_level=rospy.ERROR)\nrospy.logwarn('not')\nrospy.logerr('seen')"
    )
    assert [(r.node, r.text) for r in sim.log] == [("/x", "seen"), ("/y", "seen")]


BAD_FORMATS = {
    "wrong type": ("rospy.loginfo('%d', 'x')", "TypeError: %d format"),
    "too many": ("rospy.loginfo('a', 'b')", "TypeError: not all arguments converted"),
    "too few": ("rospy.loginfo('%s %s', 'b')", "TypeError: not enough arguments"),
    "unknown": ("rospy.loginfo('%y', 'b')", "ValueError: unsupported format character"),
    "throttled": ("rospy.loginfo_throttle(1, '%d', 'x')", "TypeError: %d format"),
}


@pytest.mark.parametrize(("call", "error"), BAD_FORMATS.values(), ids=BAD_FORMATS)
def test_a_wrong_format_does_not_end_the_node_but_is_shown_with_its_line(prints, sim, call, error):
    output = prints(f"rospy.init_node('x')\n{call}\nprint('goes on')")
    assert output.startswith('--- Logging error ---\n  File "play/scripts/script.py", line 3\n')
    assert error in output
    assert output.endswith("goes on\n")


def test_log_lines_have_the_virtual_time_and_the_node(prints, sim):
    prints("rospy.init_node('x')\nrospy.sleep(1.5)\nrospy.loginfo('late')")
    (record,) = sim.log
    assert str(record) == "[INFO] [1600088401.500000] /x: late"


def test_a_bad_callback_is_logged_with_its_lines_and_the_node_goes_on(sim, run_script):
    node = run_script(
        """
        import rospy
        from std_msgs.msg import Int32
        rospy.init_node('ear')
        def half(msg):
            return 1 / msg.data
        rospy.Subscriber('numbers', Int32, half)
        rospy.spin()
        """,
        seconds=0.1,
    )
    sim.rostopic_pub("/numbers", "std_msgs/Int32", "0", rate=10)
    sim.run(0.5)
    texts = [record.text for record in sim.log if record.level.name == "ERROR"]
    assert len(texts) > 3
    assert texts[0].startswith("bad callback: <function half at ")
    assert 'File "play/scripts/script.py", line 5, in half' in texts[0]
    assert "ZeroDivisionError" in texts[0]
    assert "simkit" not in texts[0]
    assert node.alive
    assert len(node.faults) == 1
