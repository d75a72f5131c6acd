"""Attempts to use up time, memory, disk, processes or patience, and to outlive the grading."""

import pytest

from grader.results import Status

LONGEST = 120.0
"""What ends is ended by the limits of the grader, even on a busy machine [s]."""
STUCK = {
    "loop": "while True: pass",
    "loop that catches everything": """
        while True:
            try:
                while True: pass
            except BaseException: pass
    """,
    "loop that ignores signals": """
        import signal
        for number in range(1, 65):
            try: signal.signal(number, signal.SIG_IGN)
            except (OSError, ValueError): pass
        signal.pthread_sigmask(signal.SIG_BLOCK, range(1, 65))
        while True: pass
    """,
    "loop in C": "sum(iter(int, 1))",
    "regular expression": "import re; re.match('(a+)+$', 'a' * 60 + 'b')",
    "huge number": "print(len(str(7 ** (10 ** 9))))",
    "stops itself": "import os, signal; os.kill(os.getpid(), signal.SIGSTOP); x = 1 / 0",
    "deadlock": "import _thread; lock = _thread.allocate_lock(); lock.acquire(); lock.acquire()",
    "loop in a callback": """
        import rospy, turtlesim.msg
        def handle(message):
            while True: pass
        rospy.init_node("x")
        rospy.Subscriber("/turtle1/pose", turtlesim.msg.Pose, handle)
        rospy.spin()
    """,
}


@pytest.mark.slow
@pytest.mark.parametrize("script", STUCK.values(), ids=STUCK)
def test_a_stuck_script_is_named_and_ended(arena, script):
    outcome = arena.attack(script)
    assert outcome.result.status is Status.TIMEOUT
    assert outcome.result.points == 0
    for check in outcome.result.checks:
        assert check.status is Status.TIMEOUT
        assert "broadcaster.py" in check.message
        assert "without sleeping or waiting" in check.message
    assert outcome.seconds < LONGEST


@pytest.mark.slow
def test_a_script_that_is_always_nearly_stuck_runs_out_of_time(arena):
    outcome = arena.attack("""
        import rospy
        rospy.init_node("x")
        while True:
            sum(range(10**8))
            rospy.sleep(0.001)
    """)
    first, second = outcome.result.checks
    assert first.status is Status.TIMEOUT
    assert second.status in (Status.TIMEOUT, Status.SKIPPED)
    assert outcome.result.points == 0
    assert outcome.seconds < LONGEST


MEMORY = {
    "one array": "import numpy; x = numpy.ones(10**11)",
    "a list": "x = []\nwhile True: x.append(bytearray(10**7))",
    "recursion": "def f(): f()\nf()",
    "map": "import mmap; x = mmap.mmap(-1, 10**13)",
}


@pytest.mark.slow
@pytest.mark.parametrize("script", MEMORY.values(), ids=MEMORY)
def test_memory_is_limited(arena, script):
    outcome = arena.attack(script)
    assert outcome.result.points == 0
    assert outcome.result.status in (Status.ERROR, Status.TIMEOUT)
    assert outcome.seconds < LONGEST


@pytest.mark.slow
def test_threads_are_limited(arena):
    outcome = arena.attack("""
        import _thread, time
        while True: _thread.start_new_thread(time.sleep, (1000,))
    """)
    assert outcome.result.points == 0
    assert outcome.seconds < LONGEST


FLOODS = {
    "print": "while True: print('x' * 10**6)",
    "error output": "import sys\nwhile True: sys.stderr.write('x' * 10**6)",
    "binary": "import os\nwhile True: os.write(1, bytes(range(256)) * 10_000)",
    "empty lines": "while True: print('\\n' * 10_000)",
}


@pytest.mark.slow
@pytest.mark.parametrize("script", FLOODS.values(), ids=FLOODS)
def test_a_flood_of_output_is_stopped(arena, script):
    outcome = arena.attack(script)
    assert outcome.result.points == 0
    for check in outcome.result.checks:
        assert "printed more than" in check.message
    assert outcome.seconds < LONGEST


MESSAGES = {
    "many": """
        while True: publisher.publish(tf2_msgs.msg.TFMessage())
    """,
    "large": """
        frame = geometry_msgs.msg.TransformStamped()
        frame.header.frame_id = "x" * 10**8
        while True: publisher.publish(tf2_msgs.msg.TFMessage([frame]))
    """,
    "many publishers": """
        while True: rospy.Publisher("/tf", tf2_msgs.msg.TFMessage, queue_size=1)
    """,
}


@pytest.mark.slow
@pytest.mark.parametrize("script", MESSAGES.values(), ids=MESSAGES)
def test_a_flood_of_messages_is_stopped(arena, script):
    begin = """
        import rospy, tf2_msgs.msg, geometry_msgs.msg
        rospy.init_node("x")
        publisher = rospy.Publisher("/tf", tf2_msgs.msg.TFMessage, queue_size=1)
    """
    outcome = arena.attack(begin + script)
    assert outcome.result.points == 0
    assert outcome.result.status in (Status.ERROR, Status.TIMEOUT)
    assert outcome.seconds < LONGEST


@pytest.mark.slow
def test_a_full_disk_is_the_scripts_own(arena):
    outcome = arena.attack("""
        import os
        with open(os.path.expanduser("~/big"), "wb") as file:
            while True: file.write(bytes(1 << 20))
    """)
    assert outcome.result.points == 0
    assert outcome.result.status is Status.ERROR


@pytest.mark.slow
def test_a_fork_bomb_fizzles_out(sandboxed):
    outcome = sandboxed.attack("""
        import os
        while True:
            try: os.fork()
            except OSError: pass
    """)
    assert outcome.result.points == 0
    assert outcome.seconds < LONGEST


def test_a_daemon_does_not_outlive_the_grading(arena, marked):
    outcome = arena.attack(f"""
        import os, rospy
        if os.fork() == 0:
            os.setsid()
            if os.fork() == 0:
                os.execvp("sleep", ["sleep", "{marked.word}"])
            os._exit(0)
        rospy.init_node("x")
        rospy.spin()
    """)
    assert outcome.result.points == 0
    assert not marked.is_alive()


@pytest.mark.parametrize(
    "whom",
    [
        "os.getppid()",
        "-1",
        pytest.param("1", marks=pytest.mark.slow),
        pytest.param("2", marks=pytest.mark.slow),
        pytest.param("-os.getpgrp()", marks=pytest.mark.slow),
    ],
)
def test_killing_others_kills_nobody_else(sandboxed, whom):
    outcome = sandboxed.attack(f"""
        import os, signal, rospy
        rospy.init_node("x")
        try: os.kill({whom}, signal.SIGKILL)
        except OSError: pass
        rospy.spin()
    """)
    assert outcome.result.points == 0
    assert outcome.result.status is not Status.PASSED
    assert outcome.seconds < LONGEST


@pytest.mark.slow
def test_one_that_asks_for_input_gets_none(arena):
    outcome = arena.attack("name = input('name? ')")
    assert outcome.result.status is Status.ERROR
    assert "EOFError" in outcome.result.checks[0].message


@pytest.mark.slow
def test_a_flood_of_large_messages_does_not_fill_the_memory_of_the_grader(arena):
    outcome = arena.attack("""
        import rospy, tf2_msgs.msg, geometry_msgs.msg
        rospy.init_node("x")
        publisher = rospy.Publisher("/tf", tf2_msgs.msg.TFMessage, queue_size=1)
        frame = geometry_msgs.msg.TransformStamped()
        frame.header.frame_id = "x" * 2 * 10**7
        while True:
            publisher.publish(tf2_msgs.msg.TFMessage([frame]))
            rospy.sleep(0.001)
    """)
    assert outcome.result.points == 0
    assert outcome.seconds < LONGEST
