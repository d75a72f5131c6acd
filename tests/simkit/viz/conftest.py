"""Buffers that are easy to fill, and ways to look into what was drawn."""

from __future__ import annotations

import html
import json
import math
import re
import shutil
import subprocess
import xml.etree.ElementTree as ET
from collections.abc import Callable, Iterator, Sequence
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import pytest

from simkit import Simulation
from simkit.graph import Executor, Graph
from simkit.msgs import Duration, Time, message_class, service_class
from simkit.nodes import builtin_nodes
from simkit.tf import Buffer
from simkit.tf.transformations import quaternion_from_euler
from simkit.urdf import load_robot
from simkit.viz.stage.robot import RobotShapes, robot_shapes
from simkit.viz.widgets import panel

START = 1_600_088_400
BROWSER = next(
    filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None
)
OPTIONS = (
    *("--headless", "--no-sandbox", "--disable-background-networking", "--no-first-run"),
    *("--disable-component-update", "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1"),
    *("--window-size=900,700", "--virtual-time-budget=4000"),
)
WITH_3D = ("--enable-unsafe-swiftshader", "--use-gl=angle", "--use-angle=swiftshader")
WITHOUT_3D = ("--disable-3d-apis",)
SVG = "{http://www.w3.org/2000/svg}"
VOID = {"meta", "input", "br", "img", "link"}


class FilledBuffer(Buffer):
    """A buffer with a short way to put a frame into it."""

    def put(
        self,
        parent: str,
        child: str,
        t: float = START,
        xyz: Sequence[float] = (0.0, 0.0, 0.0),
        rpy: Sequence[float] = (0.0, 0.0, 0.0),
        *,
        static: bool = False,
        by: str = "/me",
    ) -> bool:
        message: Any = message_class("geometry_msgs/TransformStamped")()
        message.header.frame_id, message.child_frame_id = parent, child
        message.header.stamp = Time.from_nsec(round(t * 1e9))
        p, q = message.transform.translation, message.transform.rotation
        p.x, p.y, p.z = map(float, xyz)
        q.x, q.y, q.z, q.w = map(float, quaternion_from_euler(*rpy))
        return (self.set_transform_static if static else self.set_transform)(message, by)


class Page(HTMLParser):
    """An HTML page taken apart; complains about tags that do not match."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.tags: list[tuple[str, dict[str, str | None]]] = []
        self.texts: list[str] = []
        self.scripts: list[str] = []
        self._open: list[str] = []
        self.feed(text)
        self.close()
        assert self._open == []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append((tag, dict(attrs)))
        if tag not in VOID:
            self._open.append(tag)

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append((tag, dict(attrs)))

    def handle_endtag(self, tag: str) -> None:
        assert self._open.pop() == tag

    def handle_data(self, data: str) -> None:
        if self._open[-1:] != ["script"]:
            self.texts.append(data)
        elif self.tags[-1][1].get("id") != "library":  # that is three.js, packed
            self.scripts.append(data)

    def by_id(self, name: str) -> tuple[str, dict[str, str | None]]:
        ((tag, attributes),) = [found for found in self.tags if found[1].get("id") == name]
        return tag, attributes

    @property
    def data(self) -> Any:
        return json.loads(self.scripts[0])


class Drive:
    """A recording of a turtle that drives straight for two seconds."""

    def __init__(self) -> None:
        self._messages: list[tuple[Time, Any]] = []
        for k in range(101):
            one: Any = message_class("geometry_msgs/TransformStamped")()
            one.header.frame_id, one.child_frame_id = "world", "turtle1"
            one.header.stamp = Time.from_nsec(START * 10**9 + k * 20_000_000)
            one.transform.translation.x, one.transform.rotation.w = k / 50, 1.0
            message: Any = message_class("tf2_msgs/TFMessage")(transforms=[one])
            self._messages.append((one.header.stamp, message))

    def topics(self) -> list[str]:
        return ["/tf"]

    def __getitem__(self, topic: str) -> list[tuple[Time, Any]]:
        return {"/tf": self._messages}[topic]


class Window:
    """A graph with a turtlesim in it."""

    def __init__(self) -> None:
        self.graph = Graph(Executor(START * 10**9))
        self.tester = self.graph.create_node("/tester")
        definition = builtin_nodes()[("turtlesim", "turtlesim_node")]
        self.node: Any = definition(self.graph.create_node("/turtlesim", {}), [])

    @property
    def frame(self) -> Any:
        return self.node.frame

    def run(self, seconds: float) -> None:
        executor = self.graph.executor
        executor.run_to(executor.now_ns + round(seconds * 1e9))

    def call(self, service: str, type_name: str, **fields: object) -> None:
        request: Any = service_class(type_name)._request_class
        answers: list[bool] = []
        self.graph.call_service(
            service, request(**fields).to_bytes(), "/tester", lambda ok, _: answers.append(ok)
        )
        self.run(0.0)
        assert answers == [True]

    def drive(self, linear: float, angular: float = 0.0, turtle: str = "turtle1") -> Any:
        """Command a turtle ten times a second until the timer that is returned is cancelled."""
        twist: Any = message_class("geometry_msgs/Twist")()
        twist.linear.x, twist.angular.z = linear, angular
        publisher = self.tester.advertise(f"/{turtle}/cmd_vel", type(twist))
        publisher.publish(twist)
        return self.tester.create_timer(Duration.from_nsec(10**8), lambda: publisher.publish(twist))


@pytest.fixture
def buffer() -> FilledBuffer:
    return FilledBuffer()


@pytest.fixture
def turtles() -> FilledBuffer:
    """Two turtles in the world, a carrot before one of them; two seconds."""
    buffer = FilledBuffer()
    for k in range(126):
        t, angle = START + 0.016 * k, 0.05 * k
        xyz = (5.5 + 2 * math.sin(angle), 7.5 - 2 * math.cos(angle), 0.0)
        buffer.put("world", "turtle1", t, xyz, (0, 0, angle), by="/turtle1_tf_broadcaster")
        buffer.put("world", "turtle2", t, (3 + k / 200, 3.5, 0), by="/turtle2_tf_broadcaster")
        if k % 6 == 0:
            buffer.put("turtle1", "carrot1", t, (0, 2, 0), by="/fixed_tf_broadcaster")
    return buffer


ARM = """
<robot name="hello_ros_robot">
  <link name="world"/>
  <link name="base_link">
    <visual>
      <geometry><cylinder length="0.05" radius="0.1"/></geometry>
      <material name="silver"><color rgba="0.75 0.75 0.75 1"/></material>
      <origin xyz="0 0 0.025"/>
    </visual>
  </link>
  <joint name="fixed" type="fixed"><parent link="world"/><child link="base_link"/></joint>
  <link name="torso">
    <visual>
      <geometry><cylinder length="0.5" radius="0.05"/></geometry>
      <material name="silver"/>
      <origin xyz="0 0 0.25"/>
    </visual>
    <collision>
      <geometry><box size="0.1 0.1 0.5"/></geometry>
      <origin xyz="0 0 0.25"/>
    </collision>
  </link>
  <joint name="hip" type="continuous">
    <axis xyz="0 0 1"/><parent link="base_link"/><child link="torso"/><origin xyz="0 0 0.05"/>
  </joint>
  <link name="upper_arm">
    <visual>
      <geometry><cylinder length="0.4" radius="0.05"/></geometry>
      <material name="orange"><color rgba="1 0.5 0 0.5"/></material>
      <origin xyz="0 0 0.2"/>
    </visual>
  </link>
  <joint name="shoulder" type="continuous">
    <axis xyz="0 1 0"/><parent link="torso"/><child link="upper_arm"/>
    <origin rpy="0 1.5708 0" xyz="0 -0.1 0.45"/>
  </joint>
</robot>
"""


@pytest.fixture
def arm_text() -> str:
    """The URDF of the arm."""
    return ARM


@pytest.fixture
def arm() -> RobotShapes:
    """The shapes of an arm: a base, a torso that also collides, a transparent upper arm."""
    return robot_shapes(load_robot(ARM, file="arm.urdf"))


@pytest.fixture
def arm_frames() -> FilledBuffer:
    """The frames of the arm, the torso turned by half a radian, the upper arm level."""
    buffer = FilledBuffer()
    buffer.put("world", "base_link", static=True)
    buffer.put("base_link", "torso", START, (0, 0, 0.05), (0, 0, 0.5))
    buffer.put("torso", "upper_arm", START, (0, -0.1, 0.45), (0, math.pi / 2, 0))
    return buffer


@pytest.fixture
def two_trees(turtles: FilledBuffer) -> FilledBuffer:
    """The turtles, and a robot on a map that nobody joined to their world."""
    turtles.put("map", "odom", START + 1, (1, 1, 0), by="/amcl")
    turtles.put("odom", "base_link", START + 1, (1, 0.5, 0), by="/diff_drive")
    turtles.put("base_link", "laser", 0, (0.2, 0, 0.3), static=True, by="/laser_tf")
    return turtles


@pytest.fixture
def hostile() -> FilledBuffer:
    """Frames with names that are not meant well."""
    buffer = FilledBuffer()
    names = [
        "<script>alert(1)</script>",
        "\"&'<b>",
        "a\x00b\x1bc\ud800",
        "</script>",
        "x" * 5000,
        "世界",
    ]
    for name in names:
        buffer.put("wörld", name, START, (1, 2, 3), by="<i>node</i>")
    return buffer


@pytest.fixture
def drive() -> Drive:
    return Drive()


@pytest.fixture
def window() -> Window:
    return Window()


ROBOTS = Path(__file__).resolve().parents[3] / "robots"
"""The packages with the robots of the book."""
CART = """<robot name="cart">
  <material name="mint"><color rgba="0.2 0.9 0.6 1"/></material>
  <link name="base">
    <inertial><origin xyz="0.1 0 0"/><mass value="6"/>
      <inertia ixx="0.05" iyy="0.1" izz="0.13" ixy="0" ixz="0" iyz="0"/></inertial>
    <visual><geometry><box size="0.4 0.3 0.1"/></geometry><material name="mint"/></visual>
    <collision><geometry><box size="0.4 0.3 0.1"/></geometry></collision>
  </link>
  <link name="mast">
    <visual><geometry><cylinder radius="0.02" length="0.2"/></geometry><material name="mint"/></visual>
  </link>
  <joint name="mount" type="fixed"><parent link="base"/><child link="mast"/><origin xyz="0 0 0.15"/></joint>
  <link name="lid">
    <inertial><mass value="1"/><inertia ixx="0.01" iyy="0.01" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial>
    <visual><geometry><sphere radius="0.05"/></geometry></visual>
  </link>
  <joint name="hinge" type="revolute"><parent link="base"/><child link="lid"/><origin xyz="0.2 0 0.1"/>
    <axis xyz="0 1 0"/><limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
  <link name="flag"><visual><geometry><box size="1 1 1"/></geometry></visual></link>
  <joint name="string" type="continuous"><parent link="base"/><child link="flag"/></joint>
  <gazebo reference="mast"><material>Gazebo/Orange</material></gazebo>
</robot>"""
"""A base with a mast that is lumped onto it, a lid on a hinge, and a flag that weighs nothing."""


@pytest.fixture
def sim() -> Iterator[Simulation]:
    """A silent simulation that finds the robots of the book."""
    with Simulation(seed=1, screen=None, package_path=[ROBOTS]) as made:
        yield made


@pytest.fixture
def cart_text() -> str:
    """The URDF of the cart."""
    return CART


@pytest.fixture
def m2wr(sim: Simulation) -> Any:
    """The book's robot with a laser, at rest on the ground of a world."""
    spawned = sim.spawn(ROBOTS / "my_robot_urdf/urdf/m2wr.urdf", name="m2wr", xyz=(0.0, 0.0, 0.1))
    sim.run(0.01)
    return spawned


@pytest.fixture
def cart(sim: Simulation) -> Any:
    """A cart that has come to rest on the ground of a world."""
    spawned = sim.spawn(CART, name="cart", xyz=(0.0, 0.0, 0.05))
    sim.run(0.1)
    return spawned


@pytest.fixture
def texts() -> Callable[[str], list[str]]:
    """The texts that an SVG shows, in order; fails unless it is XML that needs nothing else."""

    def look(svg: str) -> list[str]:
        root = ET.fromstring(svg)
        assert root.tag == f"{SVG}svg"
        for address in re.findall(r"[a-z]+://[^\"' <]*", svg):
            assert address.startswith("http://www.w3.org/")
        assert not root.findall(f".//{SVG}script")
        return [element.text or "" for element in root.iter(f"{SVG}text")]

    return look


@pytest.fixture
def read_page() -> Callable[[str], Page]:
    """Takes an HTML page apart; fails unless it needs nothing else."""

    def read(text: str) -> Page:
        page = Page(text)
        assert not re.findall(
            r'(?:src|href)=(?!"data:image/png;base64,)|@import|url\(|https?://(?!www\.w3\.org/)',
            text,
        )
        policies = [a["content"] for tag, a in page.tags if "http-equiv" in a]
        assert policies
        assert policies[0] is not None
        assert policies[0].startswith("default-src 'none'")
        return page

    return read


@pytest.fixture
def browse(tmp_path: Path) -> Callable[..., str]:
    """Opens an address in a browser without a screen; answers with its output."""
    if BROWSER is None:
        pytest.skip("no chromium on this machine")

    def browse(address: str, *options: str, three_d: bool = True) -> str:
        drawing = WITH_3D if three_d else WITHOUT_3D
        profile = f"--user-data-dir={tmp_path / 'profile'}"
        command = [BROWSER, *OPTIONS, *drawing, profile, *options, address]
        done = subprocess.run(command, capture_output=True, text=True, timeout=120, check=True)
        return done.stdout

    return browse


@pytest.fixture
def run_in_page(browse: Callable[..., str], tmp_path: Path) -> Callable[..., Any]:
    """Opens a page, runs the body of an async function in it, and returns its answer."""

    def run(page: str, script: str, *, before: str = "", three_d: bool = True) -> Any:
        # Errors are collected from before the page's own script on. A browser without a screen
        # paints when it likes; timers follow its virtual time.
        collect = (
            "<script>window.faults=[];onerror=(text)=>{faults.push(text)};"
            "onunhandledrejection=(event)=>{faults.push(String(event.reason))};"
            f"requestAnimationFrame=(draw)=>setTimeout(()=>draw(performance.now()),16);{before}</script>"
        )
        ask = (
            "<script>(async()=>{const frame=()=>new Promise((go)=>requestAnimationFrame(go));"
            f"const answer=await(async()=>{{{script}}})().catch((error)=>faults.push(String(error)));"
            "document.body.setAttribute('data-answer',JSON.stringify({answer,faults}))})()</script>"
        )
        file = tmp_path / "page.html"
        text = page.replace("<body>", f"<body>{collect}", 1).replace("</body>", f"{ask}</body>")
        file.write_text(text, encoding="utf-8")
        shown = browse(file.as_uri(), "--dump-dom", three_d=three_d)
        (answer,) = re.findall(r'data-answer="([^"]*)"', shown)
        found = json.loads(html.unescape(answer))
        assert found["faults"] == []
        return found["answer"]

    return run


class Notebook:
    """A kernel, as far as widgets talk to it."""

    def __init__(self) -> None:
        self.shown: list[dict[str, Any]] = []
        self.updates: list[dict[str, Any]] = []
        self._calls: list[Callable[[], None]] = []
        self.events = self

    def register(self, event: str, call: Callable[[], None]) -> None:
        assert event == "post_run_cell"
        self._calls.append(call)

    def end_cell(self) -> None:
        for call in self._calls:
            call()

    def display(self, bundle: dict[str, Any], *, raw: bool) -> None:
        self.shown.append(bundle)

    def update(self, bundle: dict[str, Any], *, raw: bool) -> None:
        self.updates.append(bundle)


@pytest.fixture
def notebook(monkeypatch: pytest.MonkeyPatch) -> Notebook:
    """Widgets believe that they are in this notebook."""
    made = Notebook()
    monkeypatch.setattr(panel, "running_notebook", lambda: made)
    monkeypatch.setattr("IPython.display.display", made.display)
    monkeypatch.setattr("IPython.display.DisplayHandle", lambda: made)
    return made
