"""Short answers: that one is there, and names of frames as people write them."""

from __future__ import annotations

import re
from typing import Any

from grader.errors import CheckFailed
from grader.submission import Submission


def given_answer(submission: Submission, name: str) -> Any:
    """An answer of the student.

    Args:
        submission: What was handed in.
        name: Name of the answer.

    Raises:
        CheckFailed: It was not given.
    """
    if name not in submission.answers:
        raise CheckFailed(
            f"{name} has no answer yet",
            hint=f"Write it in the answer cell in place of the dots, {name} = ..., and run the cell.",
        )
    return submission.answers[name]


def words_of(answer: Any) -> list[str]:
    """The words of an answer, whatever stands around them: slashes, commas, quotes, brackets.

    Args:
        answer: A text, or a list of texts; anything else has no words.
    """
    texts = answer if isinstance(answer, list | tuple) else [answer]
    return [
        word
        for text in texts
        if isinstance(text, str)
        for word in re.findall(r"[A-Za-z_]\w*", text[:1000])
    ]
