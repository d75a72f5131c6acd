"""Attempts to win points that were not earned."""

import pytest

from grader.results import Status

FORGED = r"""
    import os, sys, json
    lines = [
        {"event": "plan", "checks": []},
        {"event": "result", "index": 0, "result": {"name": "test_follows", "status": "passed",
         "points": 2, "max_points": 2, "title": "", "hidden": False, "message": "", "hint": ""}},
        {"event": "end"},
    ]
    text = "\n" + "\n".join(json.dumps(line) for line in lines) + "\nPASSED 5/5\n1 passed\n"
"""

ENDINGS = {
    "exit at once": "import os; os._exit(0)",
    "exit by exception": "import sys; sys.exit(0)",
    "system exit": "raise SystemExit",
    "exit in a callback": """
        import os, rospy, turtlesim.msg
        rospy.init_node("x")
        rospy.Subscriber("/turtle1/pose", turtlesim.msg.Pose, lambda message: os._exit(0))
        rospy.spin()
    """,
    "exit hook": "import atexit, os; atexit.register(os._exit, 0)",
    "raise": "raise BaseException('no')",
    "raise something that lies": """
        class Lie(Exception):
            def __str__(self): return "CheckFailed: passed"
            def __repr__(self): raise SystemExit(0)
            def __eq__(self, other): return True
        raise Lie
    """,
    "not python": "<robot/>",
    "null bytes": "x = 1\0",
    "nothing": "x = 1",
}


def cases(table, *quick):
    """The values of a table as parameters; all but the quick ones in the long run only."""
    return [
        pytest.param(
            *(case if isinstance(case, tuple) else (case,)),
            id=name,
            marks=() if name in quick else pytest.mark.slow,
        )
        for name, case in table.items()
    ]


@pytest.mark.parametrize("script", cases(ENDINGS, "exit at once", "raise something that lies"))
def test_ending_is_not_passing(arena, script):
    outcome = arena.attack(script)
    assert outcome.result.points == 0
    assert outcome.result.status in (Status.ERROR, Status.FAILED)
    for check in outcome.result.checks:
        assert "broadcaster.py" in check.message


def test_what_is_printed_is_no_result(arena):
    outcome = arena.attack(FORGED + "    print(text); sys.stderr.write(text); sys.stdout.flush()")
    assert (outcome.result.points, outcome.result.max_points) == (0, 5)


def test_what_is_written_to_every_open_file_is_no_result(arena):
    script = FORGED + (
        "    for fd in range(0, 64):\n"
        "        try: os.write(fd, text.encode())\n"
        "        except OSError: pass\n"
    )
    outcome = arena.attack(script)
    assert (outcome.result.points, outcome.result.max_points) == (0, 5)
    assert outcome.result.status is Status.ERROR


@pytest.mark.slow
def test_random_bytes_on_the_line_to_the_graph(arena):
    outcome = arena.attack("""
        import os, random, rospy
        rospy.init_node("x")
        for fd in range(3, 64):
            try: os.write(fd, random.randbytes(100_000))
            except OSError: pass
    """)
    assert outcome.result.points == 0


@pytest.mark.slow
def test_a_result_file_wins_nothing(arena):
    outcome = arena.attack("""
        import os, tempfile
        for folder in (".", "..", "../..", "/tmp", tempfile.gettempdir(), os.path.expanduser("~")):
            for name in ("results.json", "gradebook.json", "gradebook.sqlite"):
                try: open(os.path.join(folder, name), "w").write('{"points": 5}')
                except OSError: pass
    """)
    assert outcome.result.points == 0


def test_patching_what_compares_wins_nothing(arena):
    outcome = arena.attack("""
        import builtins, math, sys, unittest, numpy
        numpy.allclose = numpy.isclose = math.isclose = math.hypot = lambda *a, **k: True
        unittest.TestCase.assertTrue = lambda *a: None
        builtins.abs = lambda x: 0
        for name in list(sys.modules):
            if "pytest" in name or "grader" in name:
                sys.modules[name] = None
        import rospy
        rospy.init_node("x")
        rospy.spin()
    """)
    assert outcome.result.points == 0
    assert outcome.result.status is Status.FAILED


MODULES = (
    *("numpy.py", "rospy.py", "tf.py", "sitecustomize.py", "usercustomize.py", "pytest.py"),
    *("conftest.py", "grader.py", "simkit.py", "test_9_01.py", "encodings.py", "json.py"),
)


@pytest.mark.parametrize("folder", ["hello_ros/scripts", "hello_ros"])
def test_modules_beside_the_script_are_the_students_alone(arena, folder):
    text = "raise SystemExit('imported')\ndef test_x(): pass\n"
    files = {f"{folder}/{name}": text for name in MODULES}
    files |= {f"{folder}/pytest.ini": "[pytest]\naddopts = --collect-only\n"}
    files |= {f"{folder}/x.pth": "import os; os._exit(0)\n"}
    outcome = arena.attack("import rospy, numpy, json\nprint('here')\n", files)
    assert [check.name for check in outcome.result.checks] == ["test_follows", "test_follows_again"]
    assert outcome.result.points == 0


def test_an_honest_helper_beside_the_script_is_found(arena):
    from textwrap import dedent

    helper = "def where(message):\n    return (message.x, message.y, 0)\n"
    script = dedent("""
        import rospy, tf, turtlesim.msg
        from helper import where
        rospy.init_node("broadcaster")
        broadcaster = tf.TransformBroadcaster()
        def handle(message):
            broadcaster.sendTransform(where(message), (0, 0, 0, 1), rospy.Time.now(),
                                      "turtle1", "world")
        rospy.Subscriber("/turtle1/pose", turtlesim.msg.Pose, handle)
        rospy.spin()
    """)
    outcome = arena.attack(script, {"hello_ros/scripts/helper.py": helper})
    assert outcome.result.points == 5


REACHES = {
    "teleport": (
        'rospy.ServiceProxy("/turtle1/teleport_absolute", turtlesim.srv.TeleportAbsolute)(1, 1, 0)',
        "/turtle1/teleport_absolute",
    ),
    "drive": (
        'rospy.Publisher("/turtle1/cmd_vel", geometry_msgs.msg.Twist, queue_size=1)',
        "/turtle1/cmd_vel",
    ),
    "pose": (
        'rospy.Publisher("/turtle1/pose", turtlesim.msg.Pose, queue_size=1)',
        "/turtle1/pose",
    ),
    "clock": ('rospy.Publisher("/clock", rosgraph_msgs.msg.Clock, queue_size=1)', "/clock"),
    "parameter": ('rospy.set_param("/turtlesim/background_r", 1)', "/turtlesim/background_r"),
}


@pytest.mark.parametrize(("deed", "name"), cases(REACHES, "teleport"))
def test_reaching_for_others_is_refused_and_told(arena, deed, name):
    outcome = arena.attack(f"""
        import rospy, geometry_msgs.msg, rosgraph_msgs.msg, turtlesim.msg, turtlesim.srv
        rospy.init_node("x")
        {deed}
        rospy.spin()
    """)
    assert outcome.result.points == 0
    for check in outcome.result.checks:
        assert name in check.message
        assert "does not allow" in check.message


def test_terminal_codes_and_html_in_an_error_are_only_text(arena):
    outcome = arena.attack("""
        raise RuntimeError("\\x1b[2J\\x1b]0;owned\\x07 <script>alert(1)</script> \\u202e" + "x" * 10**6)
    """)
    for check in outcome.result.checks:
        assert "\x1b" not in check.message
        assert "\u202e" not in check.message
        assert len(check.message) < 2500
