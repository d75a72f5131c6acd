"""Words that people write into the tags of plugins besides those that the plugins read, and plugins that simkit does not have.

Source: gazebo_plugins and gazebo_ros_control of ROS Melodic and Noetic.
"""

from __future__ import annotations

from collections.abc import Mapping

_SPELLINGS: Mapping[str, Mapping[str, str]] = {
    "diff_drive": {
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
    "skid_steer_drive": {
        "wheelTorque": "torque",
        "topicName": "commandTopic",
    },
    "joint_state_publisher": {
        "joint_name": "jointName",
        "update_rate": "updateRate",
    },
    "control": {
        "robot_param": "robotParam",
        "robot_sim_type": "robotSimType",
    },
    "laser": {
        "topic": "topicName",
        "frame_name": "frameName",
        "frame_id": "frameName",
    },
    "p3d": {
        "body_name": "bodyName",
        "frame_name": "frameName",
        "xyzOffsets": "xyzOffset",
        "rpyOffsets": "rpyOffset",
    },
    "imu": {
        "frameId": "frameName",
        "frame_id": "frameName",
    },
    "imu_sensor": {
        "updateRate": "updateRateHZ",
    },
    "bumper": {
        "topicName": "bumperTopicName",
    },
}
_WITHOUT_EFFECT: Mapping[str, tuple[str, ...]] = {
    "diff_drive": ("odometryRate", "broadcastTF", "num_wheel_pairs", "ros"),
    "skid_steer_drive": ("MaxForce", "bodyName"),
    "control": ("parameters", "updateRate"),
    "laser": ("updateRate", "gaussianNoise", "hokuyoMinIntensity"),
    "imu_sensor": ("update_rate", "bodyName"),
    "bumper": ("updateRate",),
}
_READ_ELSEWHERE = {"diff_drive": ("rosDebugLevel", "legacyMode")}


def other_spellings(filename: str) -> Mapping[str, str]:
    """Words for a parameter that a plugin does not read, with the one that it does."""
    return _SPELLINGS.get(_short(filename), {})


def without_effect(filename: str) -> tuple[str, ...]:
    """Words that are often written, and have no effect."""
    return ("alwaysOn", *_WITHOUT_EFFECT.get(_short(filename), ()))


def read_elsewhere(filename: str) -> tuple[str, ...]:
    """Words that are no parameters of the plugin here, and yet are no mistakes."""
    return ("robotNamespace", *_READ_ELSEWHERE.get(_short(filename), ()))


def _short(filename: str) -> str:
    return filename.removeprefix("libgazebo_ros_").removesuffix(".so")


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

NEW_GAZEBO = ("gz-sim", "gz_", "ignition", "ign_", "gazebo_ros2_control")
"""Words in the names of plugins that belong to ROS 2 or to the newer Gazebo."""
