from __future__ import annotations

import base64

import meshcat.geometry
import numpy as np
import umsgpack

from simkit.viz.page.meshcat_window import MeshcatWindow, visualizer
from simkit.viz.stage.scene import make_scene
from simkit.viz.view import RvizView


def commands(window):
    return [umsgpack.unpackb(base64.b64decode(text)) for text in window.commands]


def test_meshcat_needs_no_server_and_the_last_command_counts():
    heard = []
    window = MeshcatWindow(lambda: heard.append(1))
    box = visualizer(window)["mine"]["box"]
    box.set_object(meshcat.geometry.Box([1, 2, 3]))
    for x in (1.0, 2.0):
        matrix = np.eye(4)
        matrix[0, 3] = x
        box.set_transform(matrix)
    thing, place = commands(window)
    assert thing["type"] == "set_object"
    assert place["matrix"][12] == 2.0
    assert len(heard) == 3
    visualizer(window)["mine"].delete()
    (gone,) = commands(window)
    assert gone["type"] == "delete"


def test_a_page_has_the_objects_that_a_person_adds(turtles, read_page):
    view = RvizView(make_scene(turtles, fixed_frame="world"))
    assert read_page(view.to_html()).data["meshcat"] == []
    view.meshcat["ball"].set_object(meshcat.geometry.Sphere(0.5))
    (command,) = read_page(view.to_html()).data["meshcat"]
    assert umsgpack.unpackb(base64.b64decode(command))["object"]["geometries"][0]["radius"] == 0.5
