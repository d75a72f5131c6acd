"""Results for people: in a terminal, in a notebook, on a page."""

from grader.report.html import exercise_html, page
from grader.report.progress import progress
from grader.report.table import print_gradebook
from grader.report.text import exercise_text

__all__ = ["exercise_html", "exercise_text", "page", "print_gradebook", "progress"]
