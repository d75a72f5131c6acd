"""Each lecture runs in a real kernel, and the numbers in its text are those that its cells print."""

from __future__ import annotations

import math
import re
import tomllib
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from tests.laws import broken_laws

ROOT = Path(__file__).resolve().parents[2]
LECTURES = sorted((ROOT / "lectures").glob("*.ipynb"))
CLAIMS = tomllib.loads((Path(__file__).parent / "lecture_numbers.toml").read_text(encoding="utf-8"))
DECIMAL = re.compile(r"(?<![\w.])(?!3\.(?:\d|10)\b)\d+\.\d+(?![\w.]\d)")
"A number with a decimal point; 3.1 to 3.10 are names of exercises."
REMEDY = "let a cell print it, correct the text, or add the computation to tests/workbook/lecture_numbers.toml"


@pytest.mark.parametrize("lecture", LECTURES, ids=lambda path: path.stem)
def test_a_lecture_runs_and_its_numbers_are_those_of_its_cells(
    lecture: Path, tmp_path: Path, run: Callable[[Path], list[Any]]
) -> None:
    mine = tmp_path / lecture.name
    mine.write_bytes(lecture.read_bytes())
    cells = run(mine)
    assert [text for kind, text in outputs(cells) if kind == "error"] == []
    text = "\n".join(cell.source for cell in cells if cell.cell_type == "markdown")
    code = "\n".join(cell.source for cell in cells if cell.cell_type == "code")
    printed = "\n".join(text for kind, text in outputs(cells) if kind == "stdout")
    claims = CLAIMS[lecture.stem]
    known = [float(number) for number in DECIMAL.findall(code + printed)]
    known += [abs(computed(formula)) for formula in claims["computed"].values()]
    broken_laws(
        [
            *(
                f"{number} in the text"
                for number in DECIMAL.findall(text)
                if not near(number, known)
            ),
            *(
                f"{said!r} is not in the text"
                for said in claims["printed"]
                if said not in flat(text)
            ),
            *(
                f"{seen!r} is not printed"
                for seen in claims["printed"].values()
                if seen not in flat(printed)
            ),
        ],
        REMEDY,
    )


def outputs(cells: list[Any]) -> Iterator[tuple[str, str]]:
    """What the cells have printed, each with its kind: stdout or error."""
    for cell in cells:
        for output in cell.get("outputs", []):
            if output.output_type == "error" or output.get("name") == "stderr":
                yield "error", output.get("text") or output.get("evalue", "")
            elif "text" in output:
                yield "stdout", output.text


def flat(text: str) -> str:
    """A text in one line, with single spaces."""
    return " ".join(text.split())


def near(number: str, known: list[float]) -> bool:
    """Whether a number of the text is one that is known, rounded as the text rounds it."""
    digits = len(number.partition(".")[2])
    return any(math.isclose(round(value, digits), float(number)) for value in known)


def computed(formula: str) -> float:
    """A formula of numbers and of the functions of `math`."""
    return float(eval(formula, vars(math) | {}))
