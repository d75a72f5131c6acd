"""The simplest attacks on every exercise of the workbook."""

from pathlib import Path

import pytest

import simkit
from grader.exercises import load_exercises
from grader.run import grade_submission
from grader.sandbox import find_sandbox
from grader.submission import Submission, read_notebook, submission_of

ROOT = Path(simkit.__file__).parent.parent
EXERCISES = load_exercises(ROOT) if (ROOT / "exercises").is_dir() else {}
SCRIPTS = {
    "exit": "import os; os._exit(0)\n",
    "idle": "import rospy; rospy.init_node('x'); rospy.spin()\n",
    "forge": 'print(\'{"event": "end"}\\n5 passed\')\n',
    "early": """
import rospy, tf
rospy.init_node('early')
broadcaster = tf.TransformBroadcaster()
for child in ('turtle1', 'turtle2', 'carrot1', 'base_link'):
    broadcaster.sendTransform((0, 0, 0), (0, 0, 0, 1), rospy.Time.now(), child, 'world')
rospy.spin()
""",
    "named": "import rospy; rospy.init_node('turtlesim'); rospy.spin()\n",
    "typed": """
import rospy
from std_msgs.msg import String
rospy.init_node('typed')
for topic in ('/turtle1/pose', '/turtle2/pose', '/tf', '/odom', '/cmd_vel', '/arm_controller/command', '/joint_states'):
    rospy.Subscriber(topic, String, print)
rospy.spin()
""",
}
"""None of them may end as a fault of ours."""


@pytest.mark.slow
@pytest.mark.parametrize("script", SCRIPTS.values(), ids=SCRIPTS)
@pytest.mark.parametrize("exercise", EXERCISES.values(), ids=EXERCISES)
def test_a_script_that_does_nothing_earns_next_to_nothing(exercise, script, launcher):
    scripts = [path for path in exercise.files if path.endswith(".py")]
    # Where no script is asked for, the same text stands in place of a robot or a launch file.
    files = dict.fromkeys(scripts or exercise.files, script)
    submission = Submission(student="eve", exercise_id=exercise.id, files=files, answers={})
    result = grade_submission(
        submission,
        exercise,
        hidden=True,
        sandbox=find_sandbox(private=(ROOT,)),
        launcher=launcher,
    )
    # A check such as "it keeps running" may pass.
    assert result.points <= 0.1 * result.max_points
    assert str(result.status) in ("failed", "error", "timeout")


@pytest.mark.slow
def test_a_frame_before_the_first_pose_is_the_students(launcher):
    exercise = EXERCISES["3.1"]
    notebook = read_notebook(exercise.hidden_checks.parent / f"{exercise.slug}.ipynb")
    solution = submission_of(notebook, exercise, student="eve")
    ((path, text),) = solution.files.items()
    begin = next(line for line in text.splitlines() if "init_node" in line)
    send = "tf.TransformBroadcaster().sendTransform((0, 0, 0), (0, 0, 0, 1), rospy.Time.now(), 'turtle1', 'world')"
    early = text.replace(begin, f"{begin}\n    for _ in range(50):\n        {send}")
    submission = Submission(student="eve", exercise_id="3.1", files={path: early}, answers={})
    result = grade_submission(
        submission, exercise, hidden=True, sandbox=find_sandbox(private=(ROOT,)), launcher=launcher
    )
    assert not [check for check in result.checks if str(check.status) == "infrastructure"]
    check = next(one for one in result.checks if "position" in one.name)
    assert str(check.status) == "failed"
    assert path.rsplit("/", 1)[-1] in check.message
