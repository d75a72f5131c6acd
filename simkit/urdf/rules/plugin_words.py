"""The plugins of gazebo_ros that simkit has: where each stands, and which parameters it reads.

Source: gazebo_plugins and gazebo_ros_control of ROS Melodic and Noetic.
"""

from __future__ import annotations

import enum
from collections.abc import Mapping
from dataclasses import dataclass, field


class Kind(enum.Enum):
    """What a parameter holds."""

    TEXT = enum.auto()
    NUMBER = enum.auto()
    NOT_NEGATIVE = enum.auto()
    POSITIVE = enum.auto()
    BOOL = enum.auto()
    JOINT = enum.auto()
    """Name of a joint."""
    JOINTS = enum.auto()
    """Names of joints with commas between them."""
    LINK = enum.auto()
    """Name of a link that must be there."""
    FRAME = enum.auto()
    """Name of a frame in TF, mostly that of a link."""


class Place(enum.Enum):
    """Where a plugin stands."""

    MODEL = "in a <gazebo> without reference"
    RAY = 'in a <sensor type="ray"> in a <gazebo reference="...">'
    IMU = 'in a <sensor type="imu"> in a <gazebo reference="...">'
    CONTACT = 'in a <sensor type="contact"> in a <gazebo reference="...">'


@dataclass(frozen=True, kw_only=True)
class PluginWord:
    """One plugin."""

    filename: str
    """Its library."""
    place: Place
    """Where it stands."""
    parameters: Mapping[str, Kind]
    """What it reads."""
    defaults: Mapping[str, str] = field(default_factory=dict)
    """Names of joints and links that it takes where they are not given."""
    other_spellings: Mapping[str, str] = field(default_factory=dict)
    """Words for a parameter that it does not read, with the one that it does."""
    unread: tuple[str, ...] = ("alwaysOn",)
    """Words that are often written, and have no effect."""
    required: tuple[str, ...] = ()
    """Parameters without which it does not work."""


_DRIVE = {
    "robotNamespace": Kind.TEXT,
    "commandTopic": Kind.TEXT,
    "odometryTopic": Kind.TEXT,
    "odometryFrame": Kind.TEXT,
    "robotBaseFrame": Kind.FRAME,
    "updateRate": Kind.NOT_NEGATIVE,
    "wheelSeparation": Kind.POSITIVE,
    "wheelDiameter": Kind.POSITIVE,
}
_BASE = {"robotBaseFrame": "base_footprint"}
_RATE = {"robotNamespace": Kind.TEXT, "updateRate": Kind.NOT_NEGATIVE}

_WORDS = (
    PluginWord(
        filename="libgazebo_ros_diff_drive.so",
        place=Place.MODEL,
        parameters={
            **_DRIVE,
            "leftJoint": Kind.JOINT,
            "rightJoint": Kind.JOINT,
            "wheelAcceleration": Kind.NOT_NEGATIVE,
            "wheelTorque": Kind.POSITIVE,
            "odometrySource": Kind.TEXT,
            "publishWheelTF": Kind.BOOL,
            "publishOdomTF": Kind.BOOL,
            "publishWheelJointState": Kind.BOOL,
            "publishTf": Kind.BOOL,
            "legacyMode": Kind.BOOL,
            "rosDebugLevel": Kind.TEXT,
        },
        defaults={**_BASE, "leftJoint": "left_joint", "rightJoint": "right_joint"},
        other_spellings={
            "torque": "wheelTorque",
            "max_wheel_torque": "wheelTorque",
            "max_wheel_acceleration": "wheelAcceleration",
            "publishOdom": "publishOdomTF",
            "publish_odom": "publishTf",
            "publish_odom_tf": "publishOdomTF",
            "publish_wheel_tf": "publishWheelTF",
            "robot_base_frame": "robotBaseFrame",
            "left_joint": "leftJoint",
            "right_joint": "rightJoint",
            "wheel_separation": "wheelSeparation",
            "wheel_diameter": "wheelDiameter",
            "update_rate": "updateRate",
            "command_topic": "commandTopic",
            "odometry_topic": "odometryTopic",
            "odometry_frame": "odometryFrame",
        },
        unread=("alwaysOn", "odometryRate", "broadcastTF", "num_wheel_pairs", "ros"),
    ),
    PluginWord(
        filename="libgazebo_ros_skid_steer_drive.so",
        place=Place.MODEL,
        parameters={
            **_DRIVE,
            "broadcastTF": Kind.BOOL,
            "leftFrontJoint": Kind.JOINT,
            "rightFrontJoint": Kind.JOINT,
            "leftRearJoint": Kind.JOINT,
            "rightRearJoint": Kind.JOINT,
            "torque": Kind.POSITIVE,
            "covariance_x": Kind.NOT_NEGATIVE,
            "covariance_y": Kind.NOT_NEGATIVE,
            "covariance_yaw": Kind.NOT_NEGATIVE,
        },
        defaults={
            **_BASE,
            "leftFrontJoint": "left_front_joint",
            "rightFrontJoint": "right_front_joint",
            "leftRearJoint": "left_rear_joint",
            "rightRearJoint": "right_rear_joint",
        },
        other_spellings={"wheelTorque": "torque", "topicName": "commandTopic"},
        unread=("alwaysOn", "MaxForce", "bodyName"),
    ),
    PluginWord(
        filename="libgazebo_ros_joint_state_publisher.so",
        place=Place.MODEL,
        parameters={**_RATE, "jointName": Kind.JOINTS},
        other_spellings={"joint_name": "jointName", "update_rate": "updateRate"},
        required=("jointName",),
    ),
    PluginWord(
        filename="libgazebo_ros_control.so",
        place=Place.MODEL,
        parameters={
            "robotNamespace": Kind.TEXT,
            "robotParam": Kind.TEXT,
            "robotSimType": Kind.TEXT,
            "controlPeriod": Kind.POSITIVE,
            "eStopTopic": Kind.TEXT,
            "legacyModeNS": Kind.BOOL,
        },
        other_spellings={"robot_param": "robotParam", "robot_sim_type": "robotSimType"},
        unread=("alwaysOn", "parameters", "updateRate"),
    ),
    PluginWord(
        filename="libgazebo_ros_laser.so",
        place=Place.RAY,
        parameters={"robotNamespace": Kind.TEXT, "topicName": Kind.TEXT, "frameName": Kind.FRAME},
        defaults={"frameName": "/world"},
        other_spellings={"topic": "topicName", "frame_name": "frameName", "frame_id": "frameName"},
        unread=("alwaysOn", "updateRate", "gaussianNoise", "hokuyoMinIntensity"),
    ),
    PluginWord(
        filename="libgazebo_ros_p3d.so",
        place=Place.MODEL,
        parameters={
            **_RATE,
            "bodyName": Kind.LINK,
            "topicName": Kind.TEXT,
            "frameName": Kind.TEXT,
            "localTwist": Kind.BOOL,
            "gaussianNoise": Kind.NOT_NEGATIVE,
            "xyzOffset": Kind.TEXT,
            "rpyOffset": Kind.TEXT,
        },
        other_spellings={
            "body_name": "bodyName",
            "frame_name": "frameName",
            "xyzOffsets": "xyzOffset",
            "rpyOffsets": "rpyOffset",
        },
        required=("bodyName", "topicName"),
    ),
    PluginWord(
        filename="libgazebo_ros_imu.so",
        place=Place.MODEL,
        parameters={
            **_RATE,
            "bodyName": Kind.LINK,
            "topicName": Kind.TEXT,
            "serviceName": Kind.TEXT,
            "frameName": Kind.FRAME,
            "gaussianNoise": Kind.NOT_NEGATIVE,
            "xyzOffset": Kind.TEXT,
            "rpyOffset": Kind.TEXT,
        },
        other_spellings={"frameId": "frameName", "frame_id": "frameName"},
        required=("bodyName",),
    ),
    PluginWord(
        filename="libgazebo_ros_imu_sensor.so",
        place=Place.IMU,
        parameters={
            "robotNamespace": Kind.TEXT,
            "topicName": Kind.TEXT,
            "frameName": Kind.FRAME,
            "updateRateHZ": Kind.NOT_NEGATIVE,
            "gaussianNoise": Kind.NOT_NEGATIVE,
            "xyzOffset": Kind.TEXT,
            "rpyOffset": Kind.TEXT,
            "initialOrientationAsReference": Kind.BOOL,
        },
        other_spellings={"updateRate": "updateRateHZ"},
        unread=("alwaysOn", "update_rate", "bodyName"),
        required=("frameName",),
    ),
    PluginWord(
        filename="libgazebo_ros_bumper.so",
        place=Place.CONTACT,
        parameters={
            "robotNamespace": Kind.TEXT,
            "bumperTopicName": Kind.TEXT,
            "frameName": Kind.FRAME,
        },
        other_spellings={"topicName": "bumperTopicName"},
        unread=("alwaysOn", "updateRate"),
    ),
)

PLUGINS: Mapping[str, PluginWord] = {word.filename: word for word in _WORDS}
"""By library."""

_NOT_HERE = (
    "ackermann_drive", "block_laser", "camera", "depth_camera", "elevator", "f3d", "force",
    "ft_sensor", "gps_sensor", "gpu_laser", "hand_of_god", "harness", "joint_pose_trajectory",
    "magnetometer_sensor", "multicamera", "openni_kinect", "planar_move", "projector",
    "prosilica", "range", "ray_sensor", "template", "tricycle_drive", "triggered_camera",
    "vacuum_gripper", "video", "wheel_slip", "wheel_odometry", "api_plugin", "paths_plugin",
)  # fmt: skip
NOT_HERE = frozenset(f"libgazebo_ros_{name}.so" for name in _NOT_HERE)
"""Plugins of gazebo_ros that simkit does not have."""

SENSOR_TYPES = (
    "altimeter", "camera", "contact", "depth", "depth_camera", "force_torque", "gps",
    "gpu_ray", "imu", "logical_camera", "magnetometer", "multicamera",
    "navsat", "ray", "rfid", "rfidtag", "rgbd_camera", "sonar", "thermal_camera",
    "wireless_receiver", "wireless_transmitter",
)  # fmt: skip
"""Types of a `<sensor>`."""

SIMULATED_SENSORS = ("ray", "imu", "contact")
"""Those that simkit has."""

NEW_GAZEBO = ("gz-sim", "gz_", "ignition", "ign_", "gazebo_ros2_control")
"""Words in the names of plugins that belong to ROS 2 or to the newer Gazebo."""
