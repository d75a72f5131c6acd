"""Physics: worlds in which robots fall, roll, swing and bump.

`plan_robot` turns a URDF into a plan, as Gazebo would; a `World` makes a `Model` of a plan and moves it
in steps of 1 ms. DART computes, and nobody outside of this package sees it. `simkit.physics.sdf` reads
world files and models of Gazebo.

    world = World()
    arm = world.add(plan_robot(load_robot(text, file="arm.urdf")))
    world.run(2_000_000_000)
    arm.joint("hip").position, arm.link_pose("upper_arm"), world.contacts()
"""

from simkit.physics.contact import Contact, Owner, Side
from simkit.physics.engine import GRAVITY, STEP_NS
from simkit.physics.errors import ModelError, NoEngineError, PhysicsError, WorldFileError
from simkit.physics.joint import Mode, ModelJoint
from simkit.physics.model import Model
from simkit.physics.plan import (
    BodyPlan,
    JointKind,
    JointPlan,
    ModelPlan,
    Mount,
    Plane,
    ShapePlan,
)
from simkit.physics.rays import MISS, Hits
from simkit.physics.robot_plan import plan_robot
from simkit.physics.sdf.model_plan import GROUND, ground_plan
from simkit.physics.stability import LostModelError
from simkit.physics.world import ORIGIN, World

__all__ = [
    "GRAVITY",
    "GROUND",
    "MISS",
    "ORIGIN",
    "STEP_NS",
    "BodyPlan",
    "Contact",
    "Hits",
    "JointKind",
    "JointPlan",
    "LostModelError",
    "Mode",
    "Model",
    "ModelError",
    "ModelJoint",
    "ModelPlan",
    "Mount",
    "NoEngineError",
    "Owner",
    "PhysicsError",
    "Plane",
    "ShapePlan",
    "Side",
    "World",
    "WorldFileError",
    "ground_plan",
    "plan_robot",
]
