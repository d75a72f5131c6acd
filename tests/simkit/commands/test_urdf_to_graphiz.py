"""urdf_to_graphiz."""

import pytest

ARM = """<robot name="arm">
  <link name="a"/>
  <link name="b"/>
  <joint name="j" type="fixed"><parent link="a"/><child link="b"/></joint>
</robot>"""


@pytest.mark.parametrize("word", ["urdf_to_graphiz", "urdf_to_graphviz"])
def test_the_tree_is_written_under_the_name_of_the_robot(simkit, tmp_path, monkeypatch, word):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "my.urdf").write_text(ARM)
    assert simkit(word, "my.urdf") == (0, "Created file arm.gv\nCreated file arm.pdf\n", "")
    assert (tmp_path / "arm.gv").read_text().startswith("digraph")
    assert (tmp_path / "arm.pdf").read_bytes().startswith(b"%PDF")


def test_a_broken_file_is_explained_in_one_line(simkit, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "my.urdf").write_text("<robot name='arm'><link name='a'></robot>")
    code, out, err = simkit("urdf_to_graphiz", "my.urdf")
    assert (code, out) == (1, "")
    assert err.startswith("simkit urdf_to_graphiz: my.urdf:1:")
