from __future__ import annotations

from dataclasses import replace

import pytest

from simkit.commands.errors import UsageError
from simkit.graph import Executor, Graph
from simkit.nodes import builtin_nodes
from simkit.nodes.rviz import RvizProgram
from simkit.packages import PackagePath
from simkit.viz import RvizSettings


@pytest.fixture
def start():
    def start(*arguments):
        node = Graph(Executor(10**18)).create_node("/rviz_1", {})
        return builtin_nodes()["rviz", "rviz"](node, list(arguments))

    return start


def test_it_is_the_node_rviz_of_the_package_rviz(start):
    program = start()
    assert isinstance(program, RvizProgram)
    assert program.exit_code is None


def test_what_the_command_line_says(start, tmp_path):
    packages = PackagePath([])

    def chosen(*arguments):
        return start(*arguments).settings(packages).fixed_frame

    assert start().settings(packages) == RvizSettings(fixed_frame="")
    assert chosen("-f", "odom") == "odom"
    assert chosen("--fixed-frame", "odom") == "odom"
    file = tmp_path / "a.rviz"
    file.write_text("Visualization Manager: {Global Options: {Fixed Frame: map}}")
    assert chosen("-d", str(file)) == "map"
    assert chosen("-d", str(file), "-f", "odom") == "odom"


def test_where_files_are_confined_only_those_of_packages_are_read(start, tmp_path):
    text = "Visualization Manager: {Global Options: {Fixed Frame: map}}"
    for name in ("hello_ros/a.rviz", "secret.rviz"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(text)
    (tmp_path / "hello_ros/package.xml").write_text("<package/>")
    packages = PackagePath([tmp_path], confined=True)
    assert start("-d", str(tmp_path / "hello_ros/a.rviz")).settings(packages).fixed_frame == "map"
    refused = start("-d", str(tmp_path / "secret.rviz"), "-f", "odom").settings(packages)
    assert refused.fixed_frame == "odom"
    assert "secret.rviz is in no package" in refused.complaint


def test_a_configuration_that_cannot_be_read_is_complained_of_and_the_view_is_there(start):
    settings = start("-d", "none.rviz").settings(PackagePath([]))
    assert settings.complaint == "cannot read none.rviz: No such file or directory."
    assert replace(settings, complaint="") == RvizSettings(fixed_frame="")


@pytest.mark.parametrize("arguments", [["-f"], ["--wrong"], ["file.rviz"]])
def test_other_arguments_are_refused_with_the_usage(start, arguments):
    with pytest.raises(UsageError, match=r"usage: rviz \[-d FILE\.rviz\] \[-f FIXED_FRAME\]"):
        start(*arguments)


def test_it_prints_where_its_page_is(start):
    program = start()
    program.show_address("http://127.0.0.1:1/x/")
    assert program.output.startswith("RViz is at http://127.0.0.1:1/x/ ")
