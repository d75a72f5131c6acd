"""A laser that sees its own robot."""

from __future__ import annotations

from tests.simkit.plugins.samples import link

BOX = link("base", '<box size="0.4 0.4 0.2"/>')


def laser(pose: str) -> str:
    return f"""<gazebo reference="base"><sensor name="eye" type="ray"><pose>{pose}</pose>
      <ray><scan><horizontal><samples>9</samples><min_angle>-0.4</min_angle><max_angle>0.4</max_angle></horizontal>
      </scan><range><min>0.05</min><max>10</max></range></ray>
      <plugin name="laser" filename="libgazebo_ros_laser.so"><topicName>scan</topicName><frameName>base</frameName>
      </plugin></sensor></gazebo>"""


def test_a_laser_that_looks_at_its_robot(watched):
    watched.spawn(BOX + laser("-0.4 0 0 0 0 0"), name="box", pose=watched.at(z=0.1))
    watched.run(1)
    (text,) = watched.found("LAS-W01")
    assert (
        "the laser 'eye' of box sees the robot itself with 9 of 9 beams: 'base' is 0.2 m away"
        in text
    )


def test_a_laser_that_looks_over_it(watched):
    watched.spawn(BOX + laser("-0.4 0 0.2 0 0 0"), name="box", pose=watched.at(z=0.1))
    watched.run(1)
    assert watched.found() == []


def test_what_check_urdf_has_warned_of_is_not_said_again(watched):
    watched.spawn(BOX + laser("0 0 0 0 0 0"), name="box", pose=watched.at(z=0.1))
    watched.run(1)
    assert watched.found() == []
