"""The book's scripts of 3.1 to 3.4 and its arm of 3.8, unmodified, with its command lines, in a real kernel."""

from __future__ import annotations

import tomllib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import nbformat

from grader.authoring.start import start

Run = Callable[[Path], list[Any]]
SCRIPTS = "hello_ros/scripts"


def book_script(root: Path, exercise: str, name: str) -> str:
    """A script of the book, as the accepted variants of an exercise keep it."""
    variants = tomllib.loads((root / f"solutions/variants_{exercise}.toml").read_text())["variant"]
    for variant in variants:
        if variant["expect"] == "accept" and "book" in variant["name"] and "files" in variant:
            for path, text in variant["files"].items():
                if path.endswith(f"/{name}"):
                    return str(text).lstrip()
    raise AssertionError(f"no variant of {exercise} has the book's {name}")


def write(root: Path, exercise: str, name: str) -> str:
    return f"%%writefile {SCRIPTS}/{name}\n" + book_script(root, exercise, name)


def shown(cell: Any) -> str:
    return "".join(output.get("text", "") for output in cell.outputs)


def test_the_book_runs_as_it_is_printed(root: Path, course: Path, run: Run) -> None:
    notebook = start(course, "3.1").notebook
    listener = write(root, "3_03", "turtle_tf_listener.py")
    traveller = write(root, "3_04", "turtle_tf_listener_time_travel.py")
    assert "continue" in listener
    cells = [
        "%load_ext simkit\nimport math\nfrom simkit import Simulation\nsim = Simulation()",
        write(root, "3_01", "turtle_tf_broadcaster.py"),
        write(root, "3_02", "fixed_tf_broadcaster.py"),
        listener,
        traveller,
        "%rosrun turtlesim turtlesim_node",
        "%rosrun hello_ros turtle_tf_broadcaster.py",
        "%rosrun hello_ros fixed_tf_broadcaster.py",
        "%rosrun tf tf_echo /turtle1 /carrot1",
        "%rosrun hello_ros turtle_tf_listener.py __name:=follower",
        "%rosrun hello_ros turtle_tf_broadcaster.py _turtle:=turtle2 __name:=second_broadcaster",
        "%rosnode list",
        "sim.rostopic_pub('/turtle1/cmd_vel', 'geometry_msgs/Twist', "
        "'{linear: {x: 1.0}, angular: {z: 0.5}}', rate=10)\nsim.run(30)\n"
        "t = sim.tf.lookup_transform('turtle2', 'turtle1').transform.translation\n"
        "print('behind', round(math.hypot(t.x, t.y), 2))",
        "%rosnode kill /follower",
        "sim.call('/kill', name='turtle2')\nsim.run(0.1)",
        "%rosrun hello_ros turtle_tf_listener_time_travel.py __name:=traveller",
        "sim.run(40)\nt = sim.tf.lookup_transform('turtle2', 'turtle1').transform.translation\n"
        "print('behind', round(math.hypot(t.x, t.y), 2), sim.nodes())",
    ]
    book = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(text) for text in cells])
    nbformat.write(book, notebook)
    ran = run(notebook)
    assert "- Translation: [2.000, 0.000, 0.000]" in shown(ran[8])
    nodes = shown(ran[11]).split()
    assert {"/follower", "/second_broadcaster", "/turtle_tf_broadcaster", "/turtlesim"} <= set(
        nodes
    )
    assert "behind 1.51" in shown(ran[12])
    delayed = float(shown(ran[16]).split()[1])
    assert delayed > 2.0, "the traveller is farther behind than the follower was"
    assert "/traveller" in shown(ran[16])


def robot_file(root: Path, exercise: str, name: str) -> str:
    """A URDF or launch file of the book, as a cell that writes it."""
    folder = "urdf" if name.endswith(".urdf") else "launch"
    return f"%%writefile hello_ros/{folder}/{name}\n" + book_script(root, exercise, name)


def test_the_books_arm_stands_as_it_is_printed(root: Path, course: Path, run: Run) -> None:
    notebook = start(course, "3.8").notebook
    cells = [
        "%load_ext simkit\nfrom simkit import Simulation\nsim = Simulation()",
        robot_file(root, "3_08", "hello_ros_robot_3.urdf"),
        robot_file(root, "3_08", "urdf_launch_3.launch"),
        "%check_urdf hello_ros/urdf/hello_ros_robot_3.urdf",
        "%roslaunch hello_ros urdf_launch_3.launch",
        "%rosparam list",
        "%rosnode list",
        "sim.run(1)",
        "%rosrun tf tf_echo /world /upper_arm",
        "%rosrun tf view_frames",
        "sim.run(6)\nprint(sim.view_frames().to_yaml())",
        "view = sim.rviz()\nprint(len(view.problems), bool(view.error))",
    ]
    book = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(text) for text in cells])
    nbformat.write(book, notebook)
    ran = run(notebook)
    assert "root Link: world has 1 child(ren)" in shown(ran[3])
    assert "warning" not in shown(ran[3])
    assert "joint_state_publisher (joint_state_publisher/joint_state_publisher)" in shown(ran[4])
    assert shown(ran[5]).split() == ["/robot_description", "/use_gui"]
    assert {"/joint_state_publisher", "/robot_state_publisher"} <= set(shown(ran[6]).split())
    assert "- Translation: [0.000, -0.100, 0.500]" in shown(ran[8])
    frames = shown(ran[10])
    for child, parent in (("base_link", "world"), ("torso", "base_link"), ("upper_arm", "torso")):
        assert f"{child}: \n  parent: '{parent}'" in frames
    assert shown(ran[11]).split() == ["0", "False"]
