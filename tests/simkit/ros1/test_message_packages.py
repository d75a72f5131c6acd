"""The message packages of ROS can be imported once the finder is installed."""

from __future__ import annotations

import importlib
import sys

import pytest

import simkit.msgs
from simkit.ros1 import message_packages


@pytest.fixture(autouse=True)
def installed(monkeypatch):
    monkeypatch.setattr(sys, "meta_path", list(sys.meta_path))
    monkeypatch.setattr(sys, "modules", sys.modules.copy())
    message_packages.uninstall()
    for package in (*simkit.msgs.packages(), "genpy"):
        for name in [n for n in sys.modules if n.split(".")[0] == package]:
            monkeypatch.delitem(sys.modules, name)
    message_packages.install()


def run(code: str) -> dict[str, object]:
    names: dict[str, object] = {}
    exec(code, names)
    return names


def test_import_of_a_module():
    names = run("import geometry_msgs.msg\nt = geometry_msgs.msg.Twist()")
    assert names["t"] == simkit.msgs.message_class("geometry_msgs/Twist")()


def test_import_of_names():
    names = run("from turtlesim.srv import Spawn, SpawnRequest, SpawnResponse")
    spawn = simkit.msgs.service_class("turtlesim/Spawn")
    assert names["Spawn"] is spawn
    assert names["SpawnRequest"] is spawn._request_class
    assert names["SpawnResponse"] is spawn._response_class


def test_import_of_everything():
    names = run("from std_msgs.msg import *")
    assert {"String", "Header", "Float64MultiArray"} <= set(names)
    assert "_names" not in names
    assert run("from std_srvs.srv import *")["TriggerResponse"]


def test_imports_as_editors_write_them():
    names = run("from std_msgs.msg._String import String\nfrom std_srvs.srv import _Empty")
    assert names["String"] is simkit.msgs.message_class("std_msgs/String")
    assert names["_Empty"].EmptyRequest._type == "std_srvs/EmptyRequest"


def test_class_names_its_module():
    made = run("from nav_msgs.msg import Odometry")["Odometry"]
    assert importlib.import_module(made.__module__).Odometry is made


@pytest.mark.parametrize("package", simkit.msgs.packages())
def test_every_package_and_name(package):
    exported = []
    for kind in ("msg", "srv"):
        try:
            module = importlib.import_module(f"{package}.{kind}")
        except ImportError:
            continue
        assert module.__all__ == sorted(module.__all__)
        assert set(module.__all__) <= set(dir(module))
        exported += [getattr(module, name) for name in module.__all__]
    assert exported


def test_classes_are_made_when_asked_for():
    module = importlib.import_module("sensor_msgs.msg")
    assert "Imu" not in vars(module)
    assert module.Imu is vars(module)["Imu"]


def test_genpy():
    names = run("import genpy, genpy.message\nfrom genpy.rostime import Time")
    assert names["genpy"].Message is simkit.msgs.Message
    assert names["Time"] is names["genpy"].Time is simkit.msgs.Time
    assert names["genpy"].message.SerializationError is simkit.msgs.SerializationError
    assert issubclass(names["genpy"].DeserializationError, names["genpy"].MessageException)


@pytest.mark.parametrize(
    ("code", "error", "text"),
    [
        ("from geometry_msgs.msg import Twst", ImportError, "'Twst' .*mean 'Twist'"),
        ("from geometry_msgs.mgs import Twist", ImportError, "'mgs' .*mean 'msg'"),
        ("from turtlesim.srv import Span", ImportError, "mean 'Spawn'"),
        ("from turtlesim.srv._Span import Span", ImportError, "_Span"),
        ("import std_srvs.msg", ImportError, "'msg' from 'std_srvs'.*Known: srv"),
        ("import sensor_msg.msg", ModuleNotFoundError, "mean 'sensor_msgs'"),
        ("import turtelsim.msg", ModuleNotFoundError, "mean 'turtlesim'"),
        ("import control", ModuleNotFoundError, "^No module named 'control'$"),
        ("import nothing_like_it", ModuleNotFoundError, "^No module named 'nothing_like_it'$"),
        ("import std_msgs.msg as m\nm.Strng", AttributeError, "mean 'String'"),
        ("import nav_msgs\nnav_msgs.msg", AttributeError, "import nav_msgs.msg"),
        ("from genpy import Tme", ImportError, "mean 'Time'"),
    ],
)
def test_misspelt_names(code, error, text):
    with pytest.raises(error, match=text):
        run(code)


def test_hasattr_answers():
    module = importlib.import_module("std_msgs.msg")
    assert hasattr(module, "String")
    assert not hasattr(module, "Strng")


def test_a_folder_of_the_same_name_does_not_hide_a_package(tmp_path, monkeypatch):
    (tmp_path / "sensor_msgs" / "msg").mkdir(parents=True)
    monkeypatch.syspath_prepend(tmp_path)
    assert run("from sensor_msgs.msg import Imu")["Imu"]


def test_a_package_with_code_of_its_own_keeps_it(tmp_path, monkeypatch):
    (tmp_path / "tf").mkdir()
    (tmp_path / "tf" / "__init__.py").write_text("from tf.listener import answer\n")
    (tmp_path / "tf" / "listener.py").write_text("answer = 42\n")
    monkeypatch.syspath_prepend(tmp_path)
    names = run("import tf\nfrom tf.msg import tfMessage\nfrom tf.srv import FrameGraph")
    assert names["tf"].answer == 42
    assert names["tfMessage"]._type == "tf/tfMessage"
    with pytest.raises(ModuleNotFoundError, match=r"^No module named 'tf.listner'$"):
        run("import tf.listner")


def test_uninstall():
    run("import std_msgs.msg")
    message_packages.install()
    message_packages.uninstall()
    with pytest.raises(ModuleNotFoundError):
        run("import std_msgs.msg")
