"""The simplest attacks on every exercise of the workbook."""

from pathlib import Path

import pytest

import simkit
from grader.exercises import load_exercises
from grader.run import grade_submission
from grader.sandbox import find_sandbox
from grader.submission import Submission

ROOT = Path(simkit.__file__).parent.parent
EXERCISES = load_exercises(ROOT) if (ROOT / "exercises").is_dir() else {}
SCRIPTS = {
    "exit": "import os; os._exit(0)\n",
    "idle": "import rospy; rospy.init_node('x'); rospy.spin()\n",
    "forge": 'print(\'{"event": "end"}\\n5 passed\')\n',
}


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
