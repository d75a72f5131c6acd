"""The reader of notebooks: any bytes are a notebook or a sentence, soon."""

from __future__ import annotations

import codecs
import json
import os
import time
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from grader.errors import SubmissionError
from grader.submission import Notebook, notebook_from_bytes, read_notebook
from grader.submission import notebook as notebook_module


def read(data: bytes | str) -> Notebook:
    return notebook_from_bytes(data.encode() if isinstance(data, str) else data, name="x.ipynb")


def read_or_reason(data: bytes | str) -> Notebook | str:
    """The notebook, or the sentence of the one error that may come."""
    try:
        return read(data)
    except SubmissionError as error:
        return str(error)


@pytest.mark.parametrize(
    "encode",
    [
        lambda text: text.encode(),
        lambda text: codecs.BOM_UTF8 + text.encode(),
        lambda text: text.encode("utf-16"),
        lambda text: text.encode("utf-16-le"),
        lambda text: text.encode("utf-16-be"),
        lambda text: codecs.BOM_UTF16_BE + text.encode("utf-16-be"),
        lambda text: text.encode("utf-32"),
    ],
)
def test_every_encoding_of_json_is_read(make: Any, encode: Any) -> None:
    text = make.json(make.cell("x = 'ü'"))
    assert read(encode(text)).cells[0].source == "x = 'ü'"


def test_bytes_that_are_no_text_do_not_lose_the_notebook(make: Any) -> None:
    data = json.dumps({"cells": [make.cell("# größe\nx")]}, ensure_ascii=False).encode("latin-1")
    assert read(data).cells[0].source.endswith("\nx")


@pytest.mark.parametrize("source", ["a\nb", ["a\n", "b"], ["a\r\n", "b"], "a\rb", ["a\n", 7, "b"]])
def test_a_source_is_a_text_or_a_list_of_lines(make: Any, source: Any) -> None:
    assert make.notebook(make.cell(source)).cells[0].source == "a\nb"


@pytest.mark.parametrize("source", [None, 7, {}, [1, 2], [[]]])
def test_a_broken_source_is_empty(make: Any, source: Any) -> None:
    assert make.notebook(make.cell(source)).cells[0].source == ""


def test_version_3_keeps_cells_in_worksheets() -> None:
    sheet = {"cells": [{"cell_type": "code", "input": ["a\n", "b"], "language": "python"}]}
    text = json.dumps({"nbformat": 3, "metadata": {"name": ""}, "worksheets": [sheet, sheet]})
    assert [cell.source for cell in read(text).cells] == ["a\nb", "a\nb"]


def test_nan_and_huge_outputs_are_dropped(make: Any) -> None:
    output = {"output_type": "stream", "text": "x" * 20_000_000, "value": float("nan")}
    start = time.perf_counter()
    notebook = make.notebook(make.cell("a", outputs=[output]))
    assert [cell.source for cell in notebook.cells] == ["a"]
    assert time.perf_counter() - start < 10


def test_half_a_surrogate_pair_can_still_be_written(make: Any) -> None:
    make.notebook(make.cell("x = '\ud800'")).cells[0].source.encode()


def test_broken_cells_and_metadata_are_left_out(make: Any) -> None:
    text = json.dumps({"cells": [None, 7, make.cell("a", metadata=None)], "metadata": []})
    notebook = read(text)
    assert [cell.source for cell in notebook.cells] == ["a"]
    assert notebook.notes[0] == "2 of the notebook's cells are broken and were left out."


def test_tags_that_are_no_texts_are_left_out(make: Any) -> None:
    notebook = make.notebook(make.cell("a", metadata={"tags": ["answer", 7, None]}))
    assert notebook.cells[0].tags == ("answer",)


@pytest.mark.parametrize("table", [None, "3.1", [], {"id": 3.1}, {"id": ["3.1"]}])
def test_a_forged_claim_is_no_claim(table: Any) -> None:
    assert read(json.dumps({"cells": [], "metadata": {"workbook": table}})).exercise_id is None


@pytest.mark.parametrize(
    ("data", "says"),
    [
        (b"", "x.ipynb is empty"),
        (b" \n", "x.ipynb is empty"),
        (b"hello", "not JSON"),
        (b'{"cells": [', "not JSON"),
        (b"\x89PNG\r\n\x1a\n", "not JSON"),
        (b"\x00" * 100, "not JSON"),
        (b"[]", "not a notebook"),
        (b"{}", "no list of cells"),
        (b'{"cells": 7}', "no list of cells"),
        (b'{"worksheets": [{"cells": 7}, 3]}', None),
        (b"[" * 1_000_000, "brackets do not pair"),
        (b"[" * 1_000_000 + b"]" * 1_000_000, "nested more than"),
        (b'{"a":' * 500 + b"1" + b"}" * 500, "nested more than"),
        (b'{"cells": [' + b"9" * 100_000 + b"]}", "not JSON"),
        (b"[" + b"1," * 5_000_000 + b"1]", "clear the outputs"),
        (b'{"cells": [' + b"{}," * 6_000 + b"{}]}", "more than 5000 cells"),
    ],
)
def test_anything_else_is_refused_with_a_sentence(data: bytes, says: str | None) -> None:
    start = time.perf_counter()
    if says is None:
        assert read(data).cells == ()
    else:
        with pytest.raises(SubmissionError, match=says) as caught:
            read(data)
        assert str(caught.value).startswith("x.ipynb ")
    assert time.perf_counter() - start < 10


def test_brackets_and_quotes_in_strings_do_not_count_as_depth(make: Any) -> None:
    source = "x = '" + "[" * 500 + '\\" \\\\" {' + "'"
    assert make.notebook(make.cell(source)).cells[0].source == source


@given(st.binary(max_size=300))
@settings(max_examples=300, deadline=None)
def test_any_bytes_are_a_notebook_or_a_submission_error(data: bytes) -> None:
    assert isinstance(read_or_reason(data), Notebook | str)


_JSON = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(),
    lambda inner: (
        st.lists(inner, max_size=5)
        | st.dictionaries(
            st.sampled_from(
                [
                    "cells",
                    "metadata",
                    "source",
                    "tags",
                    "worksheets",
                    "input",
                    "cell_type",
                    "id",
                    "x",
                ]
            ),
            inner,
        )
    ),
    max_leaves=30,
)


@given(st.fixed_dictionaries({"cells": _JSON}, optional={"metadata": _JSON, "worksheets": _JSON}))
@settings(max_examples=300, deadline=None)
def test_any_json_is_a_notebook_or_a_submission_error(value: Any) -> None:
    assert isinstance(read_or_reason(json.dumps(value)), Notebook | str)


# -- files ---------------------------------------------------------------------------------------


def test_a_link_is_refused(make: Any, tmp_path: Path) -> None:
    link = tmp_path / "link.ipynb"
    link.symlink_to(make.save(make.cell("a")))
    with pytest.raises(SubmissionError, match=r"link\.ipynb is a link"):
        read_notebook(link)


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no pipes here")
def test_a_pipe_is_refused_at_once(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe.ipynb")
    start = time.perf_counter()
    with pytest.raises(SubmissionError, match="not a regular file"):
        read_notebook(tmp_path / "pipe.ipynb")
    assert time.perf_counter() - start < 10


def test_a_folder_and_a_missing_file_are_refused(tmp_path: Path) -> None:
    (tmp_path / "folder.ipynb").mkdir()
    for name in ("folder.ipynb", "missing.ipynb"):
        with pytest.raises(SubmissionError, match=name):
            read_notebook(tmp_path / name)


def test_a_device_is_refused() -> None:
    with pytest.raises(SubmissionError, match="not a regular file"):
        read_notebook(Path(os.devnull))


def test_too_large_a_file_is_refused_unread(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(notebook_module, "MAX_NOTEBOOK_BYTES", 1_000_000)
    path = tmp_path / "big.ipynb"
    with path.open("wb") as file:
        file.truncate(10_000_000_000)
    with pytest.raises(SubmissionError, match=r"larger than 1 MB.*clear the outputs"):
        read_notebook(path)
