from __future__ import annotations

import pytest

from grader.submission.lms import LmsName, lms_name


@pytest.mark.parametrize(
    ("name", "student", "number", "rest"),
    [
        ("Ada Lovelace_1234_assignsubmission_file_", "Ada Lovelace", "1234", ""),
        ("Ada Lovelace_1234_assignsubmission_file", "Ada Lovelace", "1234", ""),
        ("Ada_L_1234_assignsubmission_file_3_01_x.ipynb", "Ada_L", "1234", "3_01_x.ipynb"),
        ("lovelaceada_123_45678_3_01_x.ipynb", "lovelaceada", "123", "3_01_x.ipynb"),
        ("lovelaceada_LATE_123_45678_3_01_x-1.ipynb", "lovelaceada", "123", "3_01_x-1.ipynb"),
        ("müllerzoë_5550_77123_work.zip", "müllerzoë", "5550", "work.zip"),
    ],
)
def test_names_of_downloads(name: str, student: str, number: str, rest: str) -> None:
    assert lms_name(name) == LmsName(student=student, number=number, rest=rest)


@pytest.mark.parametrize(
    "name",
    ["3_01_broadcast_a_tf.ipynb", "s_01_spawn.ipynb", "ada", "ada_3_01.ipynb", "3_100_200_x.ipynb"],
)
def test_other_names_are_no_downloads(name: str) -> None:
    assert lms_name(name) is None
