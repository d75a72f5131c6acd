"""How check functions become results; each test grades by checks given as text."""

import pytest

from grader.results import Status

TALK = """
#!/usr/bin/env python3
import rospy, std_msgs.msg
rospy.init_node("talk")
publisher = rospy.Publisher("/chatter", std_msgs.msg.String, queue_size=1)
rate = rospy.Rate(10)
while not rospy.is_shutdown():
    publisher.publish("hello")
    rate.sleep()
"""


def test_the_docstring_is_the_title_and_the_order_is_that_of_the_file(workbook):
    workbook.checks(
        '''
        from grader.checks import points

        @points(2)
        def test_z():
            """First
            sentence.

            Not shown.
            """

        def test_a():
            pass
        ''',
        "def test_b(): pass",
    )
    result = workbook.grade(workbook.submission(), hidden=True)
    assert [check.name for check in result.checks] == ["test_z", "test_a", "test_b"]
    assert [check.title for check in result.checks] == ["First sentence.", "a", "b"]
    assert [check.points for check in result.checks] == [2, 1, 1]
    assert [check.hidden for check in result.checks] == [False, False, True]
    assert result.status is Status.PASSED


def test_a_failed_expectation_is_the_students(run_checks):
    check = run_checks("""
        def test_x(): expect_equal(1, 2, what="the sum", hint="Add again.")
    """)["x"]
    assert check.status is Status.FAILED
    assert check.message == "The sum is not right\nexpected: 2\ngot: 1"
    assert check.hint == "Add again."
    assert check.points == 0


def test_what_builds_on_a_failure_is_skipped_with_the_reason(run_checks):
    checks = run_checks('''
        def test_a():
            """The turtle moves."""
            expect(False, "It does not.")

        @after("test_a")
        def test_b(): pass

        @after("test_b")
        def test_c(): pass

        def test_d(): pass
    ''')
    assert [checks[name].status for name in "abcd"] == ["failed", "skipped", "skipped", "passed"]
    assert "The turtle moves." in checks["b"].message


def test_a_check_of_many_inputs_needs_all_of_them(run_checks):
    checks = run_checks("""
        import pytest

        @pytest.mark.parametrize("n", [1, 2])
        def test_n(n): expect(n == 1, "no")

        @after("test_n")
        def test_z(): pass
    """)
    assert checks["n[1]"].status is Status.PASSED
    assert checks["n[2]"].status is Status.FAILED
    assert checks["z"].status is Status.SKIPPED


@pytest.mark.parametrize("code", ["assert False", "{}['x']", "raise SystemExit", "int('x')"])
def test_a_fault_in_a_check_is_ours(run_checks, code):
    checks = run_checks(f"""
        def test_x():
            {code}

        def test_y(): pass
    """)
    assert checks["x"].status is Status.INFRASTRUCTURE
    assert "not your fault" in checks["x"].message
    assert "test_9_01.py:4" in checks["x"].message
    assert checks["y"].status is Status.PASSED


def test_an_author_reads_the_fault_of_a_check_though_a_node_failed_and_the_log(
    run_checks, workbook
):
    checks = """
        from simkit.graph import LogLevel

        def test_x(run_node, sim):
            node = run_node("talk.py")
            sim.graph.log("/gazebo", LogLevel.ERROR, "the link 'eye' has no mass")
            sim.run(1)
            node.no_such_thing
    """
    broken = workbook.submission(
        "import rospy\nrospy.init_node('talk')\nraise ValueError('mine')\n"
    )
    for_student = run_checks(checks, broken)["x"]
    for_author = run_checks(checks, broken, for_author=True)["x"]
    assert (for_student.status, for_student.log) == (Status.ERROR, "")
    assert "mine" in for_student.message
    assert for_author.status is Status.INFRASTRUCTURE
    assert "AttributeError" in for_author.message
    assert "ERROR /gazebo: the link 'eye' has no mass" in for_author.log.splitlines()


NEVER_FIRST = """
    def test_x(sim, run_node):
        heard = sim.record({"/chatter": "std_msgs/String"})
        run_node("talk.py")
        sim.run(1)
        heard["/chatter"][0][1].data
"""


def test_an_error_of_a_check_is_the_students_where_their_node_ran(run_checks, workbook):
    check = run_checks(NEVER_FIRST, workbook.submission(TALK.replace("/chatter", "/tf")))["x"]
    assert check.status is Status.FAILED
    assert "talk.py has brought about: IndexError" in check.message
    assert "test_9_01.py:7" in check.message
    assert "not your fault" not in check.message
    assert "not asked for" in check.hint


def test_it_is_ours_where_the_reference_solution_fails_too(run_checks, workbook):
    workbook.write("solutions/9_01_talk.ipynb", workbook.notebook("print('solved')\n"))
    check = run_checks(NEVER_FIRST, workbook.submission("print('mine')\n"))["x"]
    assert check.status is Status.INFRASTRUCTURE
    assert "not your fault: IndexError" in check.message
    assert check.hint == ""


def test_it_stays_the_students_where_the_reference_solution_passes(run_checks, workbook):
    checks = """
        def test_x(run_node, sim):
            node = run_node("talk.py")
            sim.run(0.1)
            ["solved"].index(node.output.strip())
    """
    workbook.write("solutions/9_01_talk.ipynb", workbook.notebook("print('solved')\n"))
    check = run_checks(checks, workbook.submission("print('mine')\n"))["x"]
    assert check.status is Status.FAILED
    assert "ValueError" in check.message


@pytest.mark.parametrize(
    ("checks", "reason"),
    [
        ("def test_x(:", "SyntaxError"),
        ("import nothing_of_that_name", "nothing_of_that_name"),
        ("@after('test_y')\ndef test_x(): pass", "test_y"),
        ("x = 1", "NO_TESTS_COLLECTED"),
    ],
)
def test_checks_that_cannot_run_are_our_fault(run_checks, checks, reason):
    check = run_checks(checks)["submission"]
    assert check.status is Status.INFRASTRUCTURE
    assert reason in check.message


def test_a_public_and_a_hidden_check_cannot_share_a_name(workbook):
    workbook.checks("def test_x(): pass", "def test_x(): pass")
    result = workbook.grade(workbook.submission(), hidden=True)
    assert result.status is Status.INFRASTRUCTURE
    assert "two checks are named test_x" in result.checks[0].message


def test_seeds_are_equal_at_each_run_and_differ_between_checks(run_checks):
    text = """
        def test_a(rng, seed): expect(False, f"{seed} {rng.random()}")
        def test_b(rng, seed): expect(False, f"{seed} {rng.random()}")
    """
    first, second = run_checks(text), run_checks(text)
    assert first["a"].message == second["a"].message
    assert first["a"].message != first["b"].message


def test_a_node_of_the_student_runs(run_checks, workbook):
    workbook_may_talk(workbook)
    check = run_checks(
        """
        def test_x(sim, run_node):
            node = run_node("talk.py")
            sim.run(1.0)
            expect(node.alive, "It has ended.")
            expect_equal(sim.latest("/chatter").data, "hello", what="the text")
        """,
        workbook.submission(TALK),
    )["x"]
    assert check.message == ""
    assert check.status is Status.PASSED


def test_the_cause_in_a_node_stands_before_its_effect(run_checks, workbook):
    check = run_checks(
        """
        def test_x(sim, run_node):
            run_node("talk.py")
            sim.run(1.0)
            expect("/chatter" in sim.topics(), "Nobody talks.", hint="Publish.")
        """,
        workbook.submission("import rospy\nrospy.init_node('talk')\nx = 1 / 0\n"),
    )["x"]
    assert check.status is Status.ERROR
    lines = check.message.splitlines()
    assert lines[0].startswith("hello_ros/scripts/talk.py:3")
    assert "ZeroDivisionError" in lines[1]
    assert lines[-1] == "Nobody talks."
    assert check.hint == ""  # it is about the effect


def test_a_syntax_error_shows_its_code_its_cell_and_the_usual_cause(run_checks, workbook):
    check = run_checks(
        """
        def test_x(sim, run_node):
            run_node("talk.py")
            sim.run(1.0)
            expect(False, "Nobody talks.")
        """,
        workbook.submission("import rospy\nwhile True\n    pass\n"),
    )["x"]
    assert check.message.splitlines()[:3] == [
        "hello_ros/scripts/talk.py:2: the script stopped with an error (line 3 of the cell that writes it)",
        "SyntaxError: expected ':'",
        "    while True",
    ]
    assert "ends with a colon" in check.message


def test_a_topic_that_is_misspelt_is_named_with_the_near_one(run_checks, workbook):
    check = run_checks(
        """
        def test_x(sim, run_node):
            sim.rosrun("turtlesim", "turtlesim_node")
            run_node("talk.py")
            sim.run(1.0)
            expect(False, "It does not follow.")
        """,
        workbook.submission(
            "import rospy\nfrom turtlesim.msg import Pose\nrospy.init_node('talk')\n"
            "rospy.Subscriber('/turtle1/poes', Pose, print)\nrospy.spin()\n"
        ),
    )["x"]
    assert check.message.splitlines() == [
        "It does not follow.",
        "note: your node talk.py listens to /turtle1/poes, which no node publishes; did you mean /turtle1/pose?",
    ]


def test_what_a_check_asks_of_a_dead_node_is_the_students(run_checks, workbook):
    check = run_checks(
        """
        def test_x(sim, run_node):
            run_node("talk.py")
            sim.run(1.0)
            sim.latest("/chatter").data
        """,
        workbook.submission("raise RuntimeError('no')"),
    )["x"]
    assert check.status is Status.ERROR
    assert check.message.startswith("hello_ros/scripts/talk.py:1")


def test_a_frame_that_nobody_broadcasts_is_the_students(run_checks):
    check = run_checks("""
        def test_x(sim): sim.tf.lookup_transform("world", "turtle1")
    """)["x"]
    assert check.status is Status.FAILED
    assert "world" in check.message


def test_a_refused_node_is_told_so(run_checks, workbook):
    check = run_checks(
        """
        def test_x(sim, run_node):
            run_node("talk.py")
            sim.run(1.0)
            expect("/chatter" in sim.topics(), "Nobody talks.")
        """,
        workbook.submission(TALK),
    )["x"]
    assert "publishes on /chatter, which this exercise does not allow" in check.message
    assert check.points == 0


def test_a_script_that_was_not_handed_in_is_named(run_checks, workbook):
    check = run_checks(
        """
        def test_x(run_node): run_node("talk.py")
        """,
        workbook.submission(files={}, fixed_frame="world"),
    )["x"]
    assert check.status is Status.FAILED
    assert "talk.py was not handed in" in check.message
    assert "%%writefile hello_ros/scripts/talk.py" in check.message


def test_a_script_that_ends_early_is_told_so(run_checks, workbook):
    check = run_checks(
        """
        def test_x(sim, run_node):
            run_node("talk.py")
            sim.run(1.0)
            expect(False, "Nobody talks.")
        """,
        workbook.submission("print('bye')"),
    )["x"]
    assert check.status is Status.FAILED
    assert "talk.py had already ended" in check.message


def test_an_untouched_exercise_is_not_attempted(workbook):
    submission = workbook.submission("#!/usr/bin/env python3\n# TODO: talk\n\n")
    result = workbook.grade(submission, hidden=True)
    assert result.status is Status.NOT_ATTEMPTED
    assert (result.points, result.max_points) == (0, 4)
    assert {check.status for check in result.checks} == {Status.NOT_ATTEMPTED}


def workbook_may_talk(workbook):
    path = workbook.root / "exercises/9_01_talk.ipynb"
    path.write_text(path.read_text().replace('"/tf"', '"/tf", "/chatter"'))
