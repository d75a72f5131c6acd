"""What can be seen goes into a file of the kind that its name asks for."""

import pytest

from simkit.errors import UnknownNameError
from simkit.viz.saving import save_as

FORMATS = {".svg": lambda: "<svg>\u00e9\n\ud800</svg>\n", ".png": lambda: b"\x89PNG\r\n"}


def test_the_suffix_chooses_whatever_its_case(tmp_path):
    save_as(tmp_path / "a.SVG", FORMATS)
    save_as(str(tmp_path / "a.png"), FORMATS)
    assert (tmp_path / "a.SVG").read_bytes() == "<svg>\u00e9\n\\ud800</svg>\n".encode()
    assert (tmp_path / "a.png").read_bytes() == b"\x89PNG\r\n"


@pytest.mark.parametrize("name", ["a.jpg", "a", ".svg"])
def test_another_suffix_is_refused_with_those_that_there_are(tmp_path, name):
    with pytest.raises(UnknownNameError, match=r"\.svg") as refused:
        save_as(tmp_path / name, FORMATS, kind="replay format")
    assert "replay format" in str(refused.value)
    assert list(tmp_path.iterdir()) == []
