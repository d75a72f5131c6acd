"""The plugins that there are: what the tag of each may say, as a class under `@plugin(...)`; see `registry`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from simkit.plugins.registry import Names, plugin, tag

LASER_DEFAULT = "/world"
"""Topic and frame of a laser that says nothing of them; nobody means that."""
IMU_DEFAULT = "/default_imu"
"""Topic and service of an IMU if none is given."""
_SIM = "gazebo_ros_control/DefaultRobotHWSim"


@plugin(
    "diff_drive.DiffDrive",
    ignored=("odometryRate", "broadcastTF", "num_wheel_pairs", "ros"),
    silent=("rosDebugLevel", "legacyMode"),
)
@dataclass(frozen=True, slots=True, kw_only=True)
class DiffDriveParameters:
    """What the tag of `libgazebo_ros_diff_drive.so` says, in the order in which what is missing is reported."""

    SIDES: ClassVar[tuple[tuple[str, ...], ...]] = (("left_joint",), ("right_joint",))
    """Fields with the joints of the wheels on the left, and on the right."""
    TORQUE: ClassVar[str] = "wheel_torque"
    """Field of the torque."""

    command_topic: str = tag("commandTopic", "cmd_vel", "Topic of the commands.")
    odometry_topic: str = tag("odometryTopic", "odom", "Topic of the odometry.")
    odometry_frame: str = tag("odometryFrame", "odom", "Frame that odometry is measured in.")
    robot_base_frame: str = tag(
        "robotBaseFrame", "base_footprint", "Frame of the robot.", names=Names.FRAME
    )
    publish_wheel_tf: bool = tag("publishWheelTF", False, "Whether the wheels are on /tf.")
    publish_odom_tf: bool = tag("publishOdomTF", True, "Whether the robot is on /tf.")
    publish_wheel_joint_state: bool = tag(
        "publishWheelJointState", False, "Whether the wheels are on joint_states."
    )
    wheel_separation: float = tag(
        "wheelSeparation", 0.34, "Distance between the wheels [m].", above=0.0
    )
    wheel_diameter: float = tag("wheelDiameter", 0.15, "Diameter of a wheel [m].", above=0.0)
    wheel_acceleration: float = tag(
        "wheelAcceleration", 0.0, "Acceleration of a rim; 0: at once [m/s^2].", at_least=0.0
    )
    wheel_torque: float = tag(
        "wheelTorque", 5.0, "Largest torque of a motor [N m].", above=0.0, spellings=("torque",)
    )
    update_rate: float = tag(
        "updateRate", 100.0, "How often it reports and obeys; 0: each step [Hz].", at_least=0.0
    )
    odometry_source: str = tag(
        "odometrySource", "world", "`world`: the truth; `encoder`: what the wheels rolled."
    )
    left_joint: str = tag(
        "leftJoint", "left_joint", "Joint of the wheel on the left.", names=Names.JOINT
    )
    right_joint: str = tag(
        "rightJoint", "right_joint", "Joint of the wheel on the right.", names=Names.JOINT
    )
    publish_tf: bool = tag(
        "publishTf",
        True,
        "Whether there is odometry: its topic, and the robot on /tf.",
        spellings=("publish_odom",),
    )


@plugin("skid_steer_drive.SkidSteerDrive", ignored=("MaxForce", "bodyName"))
@dataclass(frozen=True, slots=True, kw_only=True)
class SkidSteerDriveParameters:
    """What the tag of `libgazebo_ros_skid_steer_drive.so` says, in the order in which what is missing is reported."""

    SIDES: ClassVar[tuple[tuple[str, ...], ...]] = (
        ("left_front_joint", "left_rear_joint"),
        ("right_front_joint", "right_rear_joint"),
    )
    """As those of DiffDriveParameters."""
    TORQUE: ClassVar[str] = "torque"
    """Likewise."""

    broadcast_tf: bool = tag("broadcastTF", False, "Whether the robot is on /tf.")
    left_front_joint: str = tag(
        "leftFrontJoint", "left_front_joint", "Joint of that wheel.", names=Names.JOINT
    )
    right_front_joint: str = tag(
        "rightFrontJoint", "right_front_joint", "Joint of that wheel.", names=Names.JOINT
    )
    left_rear_joint: str = tag(
        "leftRearJoint", "left_rear_joint", "Joint of that wheel.", names=Names.JOINT
    )
    right_rear_joint: str = tag(
        "rightRearJoint", "right_rear_joint", "Joint of that wheel.", names=Names.JOINT
    )
    wheel_separation: float = tag(
        "wheelSeparation", 0.4, "Distance between left and right wheels [m].", above=0.0
    )
    wheel_diameter: float = tag("wheelDiameter", 0.15, "Diameter of a wheel [m].", above=0.0)
    torque: float = tag(
        "torque", 5.0, "Largest torque of a motor [N m].", above=0.0, spellings=("wheelTorque",)
    )
    command_topic: str = tag(
        "commandTopic", "cmd_vel", "Topic of the commands.", spellings=("topicName",)
    )
    odometry_topic: str = tag("odometryTopic", "odom", "Topic of the odometry.")
    odometry_frame: str = tag("odometryFrame", "odom", "Frame that odometry is measured in.")
    robot_base_frame: str = tag(
        "robotBaseFrame", "base_footprint", "Frame of the robot.", names=Names.FRAME
    )
    update_rate: float = tag(
        "updateRate", 100.0, "How often it reports and obeys; 0: each step [Hz].", at_least=0.0
    )
    covariance_x: float = tag("covariance_x", 1e-4, "Variance of x to report [m^2].", at_least=0.0)
    covariance_y: float = tag("covariance_y", 1e-4, "Variance of y to report [m^2].", at_least=0.0)
    covariance_yaw: float = tag(
        "covariance_yaw", 1e-2, "Variance of yaw to report [rad^2].", at_least=0.0
    )


@plugin("joint_state_publisher.GazeboJointStatePublisher")
@dataclass(frozen=True, slots=True, kw_only=True)
class JointStatePublisherParameters:
    """What the tag of `libgazebo_ros_joint_state_publisher.so` says."""

    joint_name: str = tag(
        "jointName",
        "",
        "Names of joints, with commas between them.",
        required=True,
        names=Names.JOINTS,
    )
    update_rate: float = tag(
        "updateRate", 100.0, "Messages a second; 0: one each step [Hz].", at_least=0.0
    )


@plugin("control.plugin.GazeboRosControl", ignored=("parameters", "updateRate"))
@dataclass(frozen=True, slots=True, kw_only=True)
class ControlParameters:
    """What the tag of `libgazebo_ros_control.so` says."""

    robot_param: str = tag("robotParam", "robot_description", "Parameter with the URDF.")
    robot_sim_type: str = tag("robotSimType", _SIM, "How joints are moved.", choices=(_SIM,))
    control_period: float = tag(
        "controlPeriod", 0.0, "Time between two updates of the controllers [s].", above=0.0
    )
    e_stop_topic: str = tag("eStopTopic", "", "Topic of the emergency stop, a std_msgs/Bool.")
    legacy_mode_ns: bool = tag(
        "legacyModeNS", True, "Whether the gains of joints are looked for at the root."
    )


@plugin("laser.Laser", sensor="ray", ignored=("updateRate", "gaussianNoise", "hokuyoMinIntensity"))
@dataclass(frozen=True, slots=True, kw_only=True)
class LaserParameters:
    """What the tag of `libgazebo_ros_laser.so` says."""

    topic: str = tag("topicName", LASER_DEFAULT, "Topic of the scans; empty: none.")
    frame: str = tag(
        "frameName",
        LASER_DEFAULT,
        "Frame of the scans, the link of the laser.",
        names=Names.FRAME,
        spellings=("frame_id",),
    )


@plugin("p3d.P3d")
@dataclass(frozen=True, slots=True, kw_only=True)
class P3dParameters:
    """What the tag of `libgazebo_ros_p3d.so` says."""

    body_name: str = tag("bodyName", "", "Link to report.", required=True, names=Names.LINK)
    topic_name: str = tag("topicName", "", "Topic of the odometry.", required=True)
    frame_name: str = tag(
        "frameName", "world", "Where it is seen from: world, map, or a link of the model."
    )
    xyz_offset: str = tag("xyzOffset", "0 0 0", "Added to the position [m].")
    rpy_offset: str = tag("rpyOffset", "0 0 0", "Turns the orientation: roll, pitch, yaw [rad].")
    gaussian_noise: float = tag(
        "gaussianNoise",
        0.0,
        "Standard deviation of noise on velocities [m/s, rad/s].",
        at_least=0.0,
    )
    update_rate: float = tag(
        "updateRate", 0.0, "Most messages a second; 0: one each step [Hz].", at_least=0.0
    )
    local_twist: bool = tag(
        "localTwist", False, "Whether velocities are seen from the link, not from the world."
    )


@plugin("imu.Imu")
@dataclass(frozen=True, slots=True, kw_only=True)
class ImuParameters:
    """What the tag of `libgazebo_ros_imu.so` says."""

    body: str = tag("bodyName", "", "Link that it is on.", required=True, names=Names.LINK)
    topic: str = tag("topicName", IMU_DEFAULT, "Topic of the messages; empty: none.")
    service: str = tag(
        "serviceName", IMU_DEFAULT, "Service that calibrates it, which does nothing."
    )
    frame: str = tag(
        "frameName",
        "",
        "Frame of the messages; the link if it is not given.",
        names=Names.FRAME,
        spellings=("frameId", "frame_id"),
    )
    rate: float = tag(
        "updateRate", 0.0, "Messages per second; 0: one each step [Hz].", at_least=0.0
    )
    noise: float = tag("gaussianNoise", 0.0, "Standard deviation of each value.", at_least=0.0)
    xyz: str = tag("xyzOffset", "0 0 0", "Where it is on the link [m]; it has no effect.")
    rpy: str = tag("rpyOffset", "0 0 0", "How it is turned on the link [rad].")


@plugin("imu_sensor.ImuSensor", sensor="imu", ignored=("update_rate", "bodyName"))
@dataclass(frozen=True, slots=True, kw_only=True)
class ImuSensorParameters:
    """What the tag of `libgazebo_ros_imu_sensor.so` says."""

    frame: str = tag(
        "frameName",
        "",
        "Frame of the messages, the link of the IMU.",
        required=True,
        names=Names.FRAME,
    )
    topic: str = tag("topicName", "imu_data", "Topic of the messages.")
    rate: float = tag("updateRateHZ", 1.0, "Messages per second; 0: all that are measured [Hz].", at_least=0.0)  # fmt: skip
    noise: float = tag("gaussianNoise", 0.0, "Standard deviation of each value.", at_least=0.0)
    xyz: str = tag("xyzOffset", "0 0 0", "Where it is in the sensor [m]; it has no effect.")
    rpy: str = tag("rpyOffset", "0 0 0", "How its orientation is turned [rad].")
    from_start: bool = tag(
        "initialOrientationAsReference", False, "Whether orientation counts from the first one."
    )


@plugin("bumper.Bumper", sensor="contact", ignored=("updateRate",))
@dataclass(frozen=True, slots=True, kw_only=True)
class BumperParameters:
    """What the tag of `libgazebo_ros_bumper.so` says."""

    topic: str = tag("bumperTopicName", "bumper_states", "Topic of the contacts.")
    frame: str = tag(
        "frameName",
        "world",
        "Frame in the header; everything is given in that of the world.",
        names=Names.FRAME,
    )
