from __future__ import annotations

from simkit.viz.stage.marks import Marks, marks_data, moment_data

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
