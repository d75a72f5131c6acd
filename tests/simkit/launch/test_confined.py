"""Launch files of people who are not trusted: what they can read, and what they cannot."""

import pytest

from simkit import Simulation
from simkit.launch import LaunchError, evaluate
from simkit.packages import PackagePath

SECRET = "hunter2"


@pytest.fixture
def secret(tmp_path):
    """A file beside the packages, of every kind that a launch file can read."""
    folder = tmp_path / "secret"
    folder.mkdir()
    (folder / "s.txt").write_text(f"{SECRET}: {SECRET}\n")
    (folder / "s.launch").write_text(f"<launch><param name='x' value='{SECRET}'/></launch>")
    return folder


@pytest.fixture
def confined(package):
    return PackagePath([package.folder / "play"], confined=True)


READS = [
    '<param name="a" textfile="{file}"/>',
    '<param name="a" binfile="{file}"/>',
    '<param name="a" command="cat {file}"/>',
    '<param name="a" command="xacro {file}"/>',
    '<rosparam file="{file}"/>',
    '<include file="{launch}"/>',
]


# How a path may be written that leads to NAME in the folder with the secret.
WAYS = {
    "absolute": "{secret}/NAME",
    "dots": "$(find play)/../secret/NAME",
    "more dots": "$(find play)/launch/../../secret/NAME",
    "a link": "$(find play)/NAME",
    "a linked folder": "$(find play)/folder/NAME",
    "dirname": "$(dirname)/../../secret/NAME",
    "an argument": "$(arg way)/NAME",
    "an expression": "$(eval find('play') + '/../secret/NAME')",
}


@pytest.fixture
def links(write, secret):
    for name in ("s.txt", "s.launch"):
        (write.folder / name).symlink_to(secret / name)
    (write.folder / "folder").symlink_to(secret)


@pytest.mark.usefixtures("links")
@pytest.mark.parametrize(
    ("tag", "way"),
    [
        (tag, way)
        for tag in READS
        for way in WAYS
        if way != "an expression" or "command" not in tag  # it must be the whole value
    ],
)
def test_no_way_leads_out_of_the_packages(confined, package, secret, write, tag, way):
    path = WAYS[way].format(secret=secret)
    inner = tag.format(file=path.replace("NAME", "s.txt"), launch=path.replace("NAME", "s.launch"))
    text = f"<launch><arg name='way' value='$(find play)/../secret'/>{inner}</launch>"
    file = write("launch/a.launch", text)
    assert SECRET in str(evaluate(file, packages=PackagePath([package.folder])))
    with pytest.raises(LaunchError) as caught:
        evaluate(file, packages=confined)
    assert SECRET not in str(caught.value)
    assert "lies outside of the packages" in caught.value.diagnostic.what


def test_whether_a_file_is_there_is_not_told(confined, write, secret):
    (secret / "t.txt").mkdir()
    told = set()
    for name in ("s.txt", "t.txt", "u.txt"):
        path = write("a.launch", f'<launch><param name="a" textfile="{secret}/{name}"/></launch>')
        with pytest.raises(LaunchError) as caught:
            evaluate(path, packages=confined)
        told.add(str(caught.value).replace(name, "NAME"))
    assert len(told) == 1


def test_the_environment_is_empty_unless_it_is_given(confined, monkeypatch):
    monkeypatch.setenv("SECRET_WORD", SECRET)
    for value in ("$(env SECRET_WORD)", "$(eval env('SECRET_WORD'))"):
        text = f'<launch><param name="a" value="{value}"/></launch>'
        with pytest.raises(LaunchError, match="'SECRET_WORD' is not set"):
            evaluate(text, packages=confined)
    text = '<launch><param name="a" value="$(optenv SECRET_WORD none)"/></launch>'
    assert evaluate(text, packages=confined).params == {"/a": "none"}
    given = evaluate(text, packages=confined, environment={"SECRET_WORD": "given"})
    assert given.params == {"/a": "given"}


def test_no_file_is_written(confined, write, tmp_path):
    target = tmp_path / "out.yaml"
    path = write("a.launch", f'<launch><rosparam command="dump" file="{target}"/></launch>')
    with pytest.raises(LaunchError, match="writes no"):
        evaluate(path, packages=confined)
    assert not target.exists()


def test_the_own_files_are_within_reach(package, write):
    write("urdf/r.urdf", "<robot name='r'><link name='a'/></robot>")
    write("b.launch", "<launch><param name='b' value='1'/></launch>")
    write(
        "a.launch",
        """<launch><param name="a" textfile="$(find play)/urdf/r.urdf"/>
        <include file="$(dirname)/b.launch"/></launch>""",
    )
    with Simulation(package_path=[package.folder], screen=None, confined=True) as sim:
        sim.roslaunch("play", "a.launch")
        assert sim.params.get("/b") == 1
        assert sim.params.get("/a").startswith("<robot")


def test_the_launch_file_itself_must_be_in_a_package(package, secret):
    with (
        Simulation(package_path=[package.folder], screen=None, confined=True) as sim,
        pytest.raises(LaunchError, match="LCH-E08"),
    ):
        sim.roslaunch(secret / "s.launch")


def test_macros_that_were_handed_in_are_not_computed(confined, write):
    write("robot.xacro", "<robot name='${1 + 1}'/>")
    text = "<launch><param name='a' command='xacro $(find play)/robot.xacro'/></launch>"
    with pytest.raises(LaunchError) as refused:
        evaluate(text, packages=confined)
    assert "xacro is not run on what was handed in" in refused.value.diagnostic.what
    assert "simkit xacro FILE > robot.urdf" in refused.value.remedy
