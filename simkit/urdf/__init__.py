"""URDF: robots as links and joints, and what ROS makes of a file.

Two layers that are never mixed. Reading a file (`read_robot`, `check_urdf_text`) gives urdfdom's
verdict: what ROS takes, refuses, and silently loses. The rules (`simkit.urdf.rules`) say what a
teacher would say about it. `load_robot` gives the robot, or one line that says what is wrong.

`simkit.urdf.kinematics` computes where the links are, for given positions of the joints.
"""

from simkit.geometry import Vector
from simkit.urdf.loader import UrdfError, load_robot, read_robot_file
from simkit.urdf.model import (
    Box,
    Collision,
    Cylinder,
    Geometry,
    Inertial,
    Joint,
    JointType,
    Limit,
    Link,
    Material,
    Mesh,
    Mimic,
    Pose,
    Rgba,
    Robot,
    Safety,
    Sphere,
    Visual,
)
from simkit.urdf.reading import Reading, read_robot
from simkit.urdf.tree_text import tree_text
from simkit.urdf.verdict import check_urdf_text

__all__ = [
    "Box",
    "Collision",
    "Cylinder",
    "Geometry",
    "Inertial",
    "Joint",
    "JointType",
    "Limit",
    "Link",
    "Material",
    "Mesh",
    "Mimic",
    "Pose",
    "Reading",
    "Rgba",
    "Robot",
    "Safety",
    "Sphere",
    "UrdfError",
    "Vector",
    "Visual",
    "check_urdf_text",
    "load_robot",
    "read_robot",
    "read_robot_file",
    "tree_text",
]
