from __future__ import annotations

import io
import random
import stat
import time
import warnings
import zipfile

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from grader.submission import archive as archive_module
from grader.submission.archive import Item, archive_items


def zipped(
    *entries: tuple[str | zipfile.ZipInfo, bytes], method: int = zipfile.ZIP_DEFLATED
) -> bytes:
    buffer = io.BytesIO()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # about names that occur twice
        with zipfile.ZipFile(buffer, "w", method) as archive:
            for name, data in entries:
                archive.writestr(name, data)
    return buffer.getvalue()


def items(data: bytes) -> list[Item]:
    return list(archive_items(io.BytesIO(data), ()))


def test_notebooks_are_found_at_any_depth_in_order() -> None:
    found = items(zipped(("b/x.ipynb", b"2"), ("a.ipynb", b"1"), ("a.txt", b"0")))
    assert [(item.parts, item.data) for item in found] == [
        (("a.ipynb",), b"1"),
        (("b", "x.ipynb"), b"2"),
    ]


def test_an_archive_in_an_archive_is_a_folder() -> None:
    inner = zipped(("x.ipynb", b"1"), ("deeper.zip", zipped(("y.ipynb", b"2"))))
    found = items(zipped(("ada.zip", inner)))
    assert [(item.parts, item.is_folder) for item in found] == [
        (("ada",), True),
        (("ada", "x.ipynb"), False),
    ]


def test_litter_is_left_out() -> None:
    names = ["__MACOSX/._x.ipynb", ".ipynb_checkpoints/x.ipynb", "a/.hidden.ipynb"]
    assert items(zipped(*[(name, b"1") for name in names])) == []


def link(name: str) -> zipfile.ZipInfo:
    info = zipfile.ZipInfo(name)
    info.external_attr = (stat.S_IFLNK | 0o777) << 16
    return info


def pipe(name: str) -> zipfile.ZipInfo:
    info = zipfile.ZipInfo(name)
    info.external_attr = (stat.S_IFIFO | 0o777) << 16
    return info


def locked(data: bytes) -> bytes:
    """The same archive with the mark of a password on each entry."""
    broken = bytearray(data)
    for signature, offset in ((b"PK\x03\x04", 6), (b"PK\x01\x02", 8)):
        start = broken.find(signature)
        broken[start + offset] |= 1
    return bytes(broken)


def cut(data: bytes) -> bytes:
    """The same archive with other bytes in its first entry."""
    broken = bytearray(data)
    broken[40:60] = bytes(20)
    return bytes(broken)


@pytest.mark.parametrize(
    ("data", "says"),
    [
        (zipped(("../../x.ipynb", b"1")), "leads out"),
        (zipped(("/etc/x.ipynb", b"1")), "leads out"),
        (zipped(("C:\\x.ipynb", b"1")), "leads out"),
        (zipped(("a\\..\\..\\x.ipynb", b"1")), "leads out"),
        (zipped(("a/" * 20 + "x.ipynb", b"1")), "too deep"),
        (zipped((link("x.ipynb"), b"/etc/passwd")), "link"),
        (zipped((pipe("x.ipynb"), b"")), "link or no regular file"),
        (zipped(("x.ipynb", b"1"), method=zipfile.ZIP_LZMA), "unusual"),
        (locked(zipped(("x.ipynb", b"1"))), "password"),
        (cut(zipped(("x.ipynb", random.Random(1).randbytes(100)))), "damaged"),
        (b"no zip", "cannot be read as a zip file"),
        (b"", "cannot be read as a zip file"),
    ],
)
def test_hostile_and_broken_entries_give_a_sentence(data: bytes, says: str) -> None:
    (item,) = items(data)
    assert item.data is None
    assert says in item.problem


def test_a_bomb_costs_one_budget_and_the_neighbour_is_read(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(archive_module, "MAX_BYTES_PER_STUDENT", 3_000_000)
    monkeypatch.setattr(archive_module, "MAX_NOTEBOOK_BYTES", 2_000_000)
    bombs = [(f"eve/{n}.ipynb", bytes(1_999_999)) for n in range(5)]
    found = items(zipped(("eve/0a.ipynb", bytes(50_000_000)), *bombs, ("ada/x.ipynb", b"1")))
    data = {item.parts: item.data for item in found}
    assert data["ada", "x.ipynb"] == b"1"
    assert sum(len(one) for one in data.values() if one is not None) < 3_000_000
    assert all("larger than" in item.problem for item in found if item.data is None)


def test_a_nested_bomb_costs_the_same_budget(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(archive_module, "MAX_BYTES_PER_STUDENT", 1_000_000)
    inner = zipped(*[(f"{n}.ipynb", bytes(900_000)) for n in range(4)])
    found = items(zipped(("eve.zip", inner)))
    assert len([item for item in found if item.data is not None]) == 1


def test_too_many_entries_are_refused_before_they_are_listed() -> None:
    data = zipped(*[(f"{n}.txt", b"") for n in range(3)])
    signatures = data + b"PK\x01\x02" * 30_000
    start = time.perf_counter()
    (item,) = items(signatures)
    assert "more than 20000 files" in item.problem
    assert time.perf_counter() - start < 10


def test_a_lie_about_the_size_is_not_believed() -> None:
    data = bytearray(zipped(("x.ipynb", b"a" * 1000)))
    start = data.find(b"PK\x01\x02")
    data[start + 24 : start + 28] = (7).to_bytes(4, "little")
    (item,) = items(bytes(data))
    assert item.data is None or len(item.data) <= 1000


def changed(data: bytes, at: int, value: int) -> bytes:
    at %= len(data)
    return data[:at] + bytes([value]) + data[at + 1 :]


@given(
    st.lists(st.tuples(st.integers(0, 10_000), st.integers(0, 255)), min_size=1, max_size=8),
)
@settings(max_examples=200, deadline=None)
def test_any_damage_gives_items_and_no_other_error(damage: list[tuple[int, int]]) -> None:
    data = zipped(("a/x.ipynb", b"[1, 2]" * 20), ("b.zip", zipped(("y.ipynb", b"{}"))))
    for at, value in damage:
        data = changed(data, at, value)
    for item in items(data):
        assert item.is_folder or item.data is not None or item.problem
