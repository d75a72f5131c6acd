"""MD5 sums are those of real ROS (Noetic)."""

from __future__ import annotations

import pytest

from simkit.msgs import message_class, service_class
from simkit.msgs.catalog import DEFINITIONS, service_definition_texts
from simkit.msgs.definition import parse_definition
from simkit.msgs.digest import definition_of
from simkit.msgs.generate import generated_files

MESSAGES = """
actionlib_msgs/GoalStatusArray 8b2b82f13216d0a8ea88bd3af735e619
actionlib_tutorials/AveragingAction 628678f2b4fa6a5951746a4a2d39e716
actionlib_tutorials/FibonacciAction f59df5767bf7634684781c92598b2406
bond/Constants 6fc594dc1d7bd7919077042712f8c8b0
control_msgs/FollowJointTrajectoryAction bc4f9b743838566551c0390c65f1a248
control_msgs/GripperCommandAction 950b2a6ebe831f5d4f4ceaba3d8be01e
control_msgs/JointControllerState 987ad85e4756f3aef7f1e5e7fe0595d1
control_msgs/JointJog 1685da700c8c2e1254afc92a5fb89c96
control_msgs/JointTolerance f544fe9c16cf04547e135dd6063ff5be
control_msgs/JointTrajectoryAction a04ba3ee8f6a2d0985a6aeaf23d9d7ad
control_msgs/JointTrajectoryControllerState 10817c60c2486ef6b33e97dcd87f4474
control_msgs/JointTrajectoryGoal 2a0eff76c870e8595636c2a562ca298e
control_msgs/PidState b138ec00e886c10e73f27e8712252ea6
control_msgs/PointHeadAction 7252920f1243de1b741f14f214125371
control_msgs/PointHeadGoal 8b92b1cd5e06c8a94c917dc3209a4c1d
control_msgs/SingleJointPositionAction c4a786b7d53e5d0983decf967a5a779e
controller_manager_msgs/ControllerState aeb6b261d97793ab74099a3740245272
controller_manager_msgs/ControllersStatistics a154c347736773e3700d1719105df29d
gazebo_msgs/ContactsState acbcb1601a8e525bf72509f18e6f668d
gazebo_msgs/LinkState 0818ebbf28ce3a08d48ab1eaa7309ebe
gazebo_msgs/LinkStates 48c080191eb15c41858319b4d8a609c2
gazebo_msgs/ModelState 9330fd35f2fcd82d457e54bd54e10593
gazebo_msgs/ModelStates 48c080191eb15c41858319b4d8a609c2
gazebo_msgs/ODEJointProperties 1b744c32a920af979f53afe2f9c3511f
gazebo_msgs/ODEPhysics 667d56ddbd547918c32d1934503dc335
gazebo_msgs/PerformanceMetrics 884f71fd5037b886ec5e126b83c4425a
gazebo_msgs/WorldState de1a9de3ab7ba97ac0e9ec01a4eb481e
geometry_msgs/PoseWithCovarianceStamped 953b798c0f514ff060a53a3498ce6246
geometry_msgs/TransformStamped b5764a33bfeb3588febc2682852579b0
geometry_msgs/Twist 9f195f881246fdfa2798d1d3eebca84a
nav_msgs/OccupancyGrid 3381f2d731d4076ec5c71b0759edbe4e
nav_msgs/Odometry cd5e73d190d741a2f92e81eda573aca7
nav_msgs/Path 6227e2b7e9cce15051f669a5e197bbf7
rosgraph_msgs/Clock a9c97c1d230cfc112e270351a944ee47
rosgraph_msgs/Log acffd30cd6b6de30f120938c17c593fb
rospy_tutorials/Floats 420cd38b6b071cd49f2970c3e2cee511
rospy_tutorials/HeaderString c99a9440709e4d4a9716d55b8270d5e7
sensor_msgs/CameraInfo c9a58c1b0b154e0e6da7578cb991d214
sensor_msgs/Image 060021388200f6f0f447d0fcd9c64743
sensor_msgs/Imu 6a62c6daae103f4ff57a132d6f95cec2
sensor_msgs/JointState 3066dcd76a6cfaef579bd0f34173e9fd
sensor_msgs/LaserScan 90c7ef2dc6895d81024acba2ac42f369
sensor_msgs/PointCloud2 1158d486dd51d683ce2f1be655c3c181
std_msgs/Byte ad736a2e8818154c487bb80fe42ce43b
std_msgs/Char 1bf77f25acecdedba0e224b162199717
std_msgs/Duration 3e286caf4241d664e55f3ad380e2ae46
std_msgs/Empty d41d8cd98f00b204e9800998ecf8427e
std_msgs/Float64MultiArray 4b7d974086d4060e7db4613a7e6c3ba4
std_msgs/Header 2176decaecbce78abc3b96ef049fabed
std_msgs/String 992ce8a1687cec8c8bd883ec73ca41d1
std_msgs/Time cd7166c74c552c311fbcc2fe5a7bc289
tf/tfMessage 94810edda583a504dfda3829e70d7eec
tf2_msgs/LookupTransformAction 7ee01ba91a56c2245c610992dbaa3c37
tf2_msgs/TF2Error bc6848fd6fd750c92e38575618a4917d
tf2_msgs/TFMessage 94810edda583a504dfda3829e70d7eec
trajectory_msgs/JointTrajectory 65b4f94a94d1ed67169da35a02f33d3f
turtlesim/Color 353891e354491c51aabe32df673fb446
turtlesim/Pose 863b248d5016ca62ea2e895ae5265cf9
visualization_msgs/Marker 4048c9de2a16f4ae8e0538085ebf1b97
visualization_msgs/MarkerArray d155b9ce5188fbaf89745847fd5882d7
"""

SERVICES = """
control_msgs/QueryCalibrationState 28af3beedcb84986b8e470dc5470507d
control_msgs/QueryTrajectoryState ec93cdecbd8062d761aa52b7c90cd44b
controller_manager_msgs/ListControllerTypes c1d4cd11aefa9f97ba4aeb5b33987f4e
controller_manager_msgs/ListControllers 1341feb2e63fa791f855565d0da950d8
controller_manager_msgs/LoadController 647e5c54b8d6468952d8d31f1efe96c0
controller_manager_msgs/ReloadControllerLibraries 40e8c411fd1797d2e2c486018f846040
controller_manager_msgs/SwitchController b29a7abc673b2c54c14b54e50f8d06a5
controller_manager_msgs/UnloadController 647e5c54b8d6468952d8d31f1efe96c0
diagnostic_msgs/AddDiagnostics e6ac9bbde83d0d3186523c3687aecaee
diagnostic_msgs/SelfTest ac21b1bab7ab17546986536c22eb34e9
dynamic_reconfigure/Reconfigure bb125d226a21982a4a98760418dc2672
gazebo_msgs/ApplyBodyWrench 585b9f9618aa0581b207e2f2d90866bc
gazebo_msgs/ApplyJointEffort c0039811b8cc919490b3cff748cdf46b
gazebo_msgs/BodyRequest 5eade9afe7f232d78005bd0cafeab755
gazebo_msgs/DeleteLight ae11ea8100d536d5b92c2b5917abf912
gazebo_msgs/DeleteModel 9ce56b4e9e54616de25d796dc972a262
gazebo_msgs/GetJointProperties 7b30be900f50aa21efec4a0ec92d91c9
gazebo_msgs/GetLightProperties df2cef87e13e2e6990e81e8aaa454c19
gazebo_msgs/GetLinkProperties 0e06a70386d0ee3fb880c02f23fcd821
gazebo_msgs/GetLinkState 09d6c98cce97b35f7ab9bd70300657ab
gazebo_msgs/GetModelProperties 5717f7bd34ed990fa80e28b3015027a3
gazebo_msgs/GetModelState 4c515e936d3319c9610c559c60bfc3d4
gazebo_msgs/GetPhysicsProperties 575a5e74786981b7df2e3afc567693a6
gazebo_msgs/GetWorldProperties 36bb0f2eccf4d8be971410c22818ba3f
gazebo_msgs/JointRequest 0be1351618e1dc030eb7959d9a4902de
gazebo_msgs/SetJointProperties 15a76e921b1410c698d82782ea5fa370
gazebo_msgs/SetJointTrajectory 88f5c10979e3f9649d5ae87a3b12aa65
gazebo_msgs/SetLightProperties e6f13430c57278bb364aca53a1bf5ebf
gazebo_msgs/SetLinkProperties d534ce1b36ee99de0ffa806c3a6348f0
gazebo_msgs/SetLinkState 8a5146eb66ae4d26b0860b08f3f271be
gazebo_msgs/SetModelConfiguration 10e3139d3b669c40afc057d38956fff7
gazebo_msgs/SetModelState 5b3ab0281d4f5445def017e3a2e4a07b
gazebo_msgs/SetPhysicsProperties 97e2057080558ce4730434b5fae75c91
gazebo_msgs/SpawnModel 9ed9c82c96abe1a00c3e8cdaeee24413
nav_msgs/GetMap 6cdd0a18e0aff5b0a3ca2326a89b54ff
nav_msgs/GetPlan 421c8ea4d21c6c9db7054b4bbdf1e024
nav_msgs/LoadMap 22e647fdfbe3b23c8c9f419908afaebd
nav_msgs/SetMap c36922319011e63ed7784112ad4fdd32
roscpp/Empty d41d8cd98f00b204e9800998ecf8427e
roscpp/GetLoggers 32e97e85527d4678a8f9279894bb64b0
roscpp/SetLoggerLevel 51da076440d78ca1684d36c868df61ea
roscpp_tutorials/TwoInts 6a2e34150c00229791cc89ff309fff21
rospy_tutorials/AddTwoInts 6a2e34150c00229791cc89ff309fff21
sensor_msgs/SetCameraInfo bef1df590ed75ed1f393692395e15482
std_srvs/Empty d41d8cd98f00b204e9800998ecf8427e
std_srvs/SetBool 09fb03525b03e7ea1fd3992bafd87e16
std_srvs/Trigger 937c9679a518e3a18d831e57125ea522
tf/FrameGraph c4af9ac907e58e906eb0b6e3c58478c0
tf2_msgs/FrameGraph 437ea58e9463815a0d511c7326b686b0
turtlesim/Kill c1f3d28f1b044c871e6eff2e9fc3c667
turtlesim/SetPen 9f452acce566bf0c0954594f69a8e41b
turtlesim/Spawn 0b2d2e872a8e2887d5ed626f2bf2c561
turtlesim/TeleportAbsolute a130bc60ee6513855dc62ea83fcc5b20
turtlesim/TeleportRelative 9d5c2dcd348ac8f76ce2a4307bd63a13
"""


@pytest.mark.parametrize("line", MESSAGES.split("\n")[1:-1])
def test_message(line):
    name, md5 = line.split()
    assert message_class(name)._md5sum == md5


@pytest.mark.parametrize("line", SERVICES.split("\n")[1:-1])
def test_service(line):
    name, md5 = line.split()
    assert service_class(name)._md5sum == md5


def types_within(definition):
    """The message types that a sum covers: those of the fields, and of their fields."""
    nested = {field.base for field in definition.fields if "/" in field.base}
    return nested.union(*(types_within(definition_of(name)) for name in nested))


def covered():
    """Every type whose fields a sum of these tables holds fast."""
    messages, services = (
        {line.split()[0] for line in table.split("\n")[1:-1]} for table in (MESSAGES, SERVICES)
    )
    found = {f"{name}.msg" for name in messages} | {f"{name}.srv" for name in services}
    definitions = [definition_of(name) for name in messages]
    for name in services:
        definitions += [parse_definition(text, name) for text in service_definition_texts(name)]
    return found | {f"{name}.msg" for one in definitions for name in types_within(one)}


def test_each_definition_written_by_hand_has_a_known_sum():
    known, generated = covered(), set(generated_files())
    missing = []
    for path in sorted(DEFINITIONS.rglob("*.*")):
        if path in generated or path.suffix not in (".msg", ".srv", ".action"):
            continue
        name = f"{path.parent.parent.name}/{path.stem}"
        typed = f"{name}Action.msg" if path.suffix == ".action" else name + path.suffix
        if typed not in known:
            missing.append(typed)
    if missing:
        pytest.fail(
            f"no MD5 sum is known for {', '.join(missing)}, so a misspelt field would pass: add a line to MESSAGES or "
            "SERVICES in tests/simkit/msgs/test_digest.py, with the sum of real ROS (`rosmsg md5 NAME`, `rossrv md5 NAME`)"
        )


def test_requests_have_sums_of_their_own():
    spawn = service_class("gazebo_msgs/SpawnModel")
    assert spawn._request_class._md5sum == "6d0eba5753761cd57e6263a056b79930"
    assert spawn._response_class._md5sum == "2ec6f3eff0161f4257b808b12bc830c2"


def test_full_text_holds_each_nested_message_once():
    text = message_class("geometry_msgs/PoseStamped")._full_text
    assert text.startswith("std_msgs/Header header\ngeometry_msgs/Pose pose\n\n" + "=" * 80)
    parts = [line for line in text.splitlines() if line.startswith("MSG: ")]
    assert parts == [
        "MSG: std_msgs/Header",
        "MSG: geometry_msgs/Pose",
        "MSG: geometry_msgs/Point",
        "MSG: geometry_msgs/Quaternion",
    ]
