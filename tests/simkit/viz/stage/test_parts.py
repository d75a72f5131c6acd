from __future__ import annotations

from simkit.urdf import Box, Cylinder, Sphere
from simkit.viz.stage.parts import Marks, TriangleMesh, half_extents, marks_data, moment_data

SOME = Marks(
    name="contacts",
    label="Contacts",
    color="#00ff00",
    points=((1.0, 2.0, 3.0), (0.12345, 0.0, 0.0)),
    lines=(((0.0, 0.0, 0.0), (1.0, 0.0, 0.0)),),
    shines_through=True,
)


def test_what_changes_are_coordinates_in_tenths_of_a_millimetre():
    assert moment_data(SOME) == {
        "points": [1.0, 2.0, 3.0, 0.1235, 0.0, 0.0],
        "lines": [[0.0, 0.0, 0.0, 1.0, 0.0, 0.0]],
    }


def test_the_script_of_a_view_gets_name_and_colour_as_well():
    data = marks_data(SOME)
    assert (data["name"], data["color"], data["through"]) == ("contacts", "#00ff00", True)
    assert data["points"] == moment_data(SOME)["points"]


def test_the_box_around_each_shape():
    origin = (0, 0, 0)
    assert half_extents(Box((1.0, 2.0, 3.0))) == (origin, (0.5, 1.0, 1.5))
    assert half_extents(Cylinder(0.1, 2.0)) == (origin, (0.1, 0.1, 1.0))
    assert half_extents(Sphere(2.0)) == (origin, (2, 2, 2))
    mesh = TriangleMesh(vertices=b"", triangles=b"", low=(0, 0, 2), high=(1, 4, 4))
    assert half_extents(mesh) == ((0.5, 2.0, 3.0), (0.5, 2.0, 1.0))
