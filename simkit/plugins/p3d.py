"""The plugin `libgazebo_ros_p3d.so`: publishes the true pose of a link.

Source: gazebo_ros_p3d of ROS Noetic.
"""

from __future__ import annotations

import dataclasses
from typing import Any, ClassVar

from simkit.errors import near_names
from simkit.geometry import Transform, Vector, conjugate, multiply, rotate
from simkit.msgs import message_class
from simkit.plugins.noise import generator
from simkit.plugins.odometry import (
    Covariances,
    Frames,
    diagonal_covariance,
    odometry_message,
    set_pose,
)
from simkit.plugins.parameters import read_triple, read_turn, resolve_frame, tf_prefix, topic_of
from simkit.plugins.plugin import NEVER, Plugin
from simkit.plugins.site import PluginError, Site
from simkit.plugins.tags import P3dParameters

WORLD_FRAMES = ("world", "/world", "map", "/map")
"""Names that mean the world itself."""


class P3d(Plugin[P3dParameters]):
    """Publishes where a link is and how it moves, while somebody listens.

    Noise is on the velocities only. Names of a tag without `robotNamespace` are at the root, also in a
    world file.

    Args:
        site: Where it works.
        parameters: What its tag says.

    Raises:
        PluginError: The model has no such link, or the frame is neither the world nor a link.
    """

    Parameters: ClassVar[type[P3dParameters]] = P3dParameters

    def __init__(self, site: Site, parameters: P3dParameters) -> None:
        super().__init__(dataclasses.replace(site, namespace=site.namespace or ""), parameters)
        self._topic = topic_of(self.site, "topicName", parameters.topic_name)
        self._body = self._link("bodyName", parameters.body_name)
        frame = parameters.frame_name
        self._reference = None if frame in WORLD_FRAMES else self._link("frameName", frame)
        self._offset = Transform(
            read_triple(site, "xyzOffset", parameters.xyz_offset),
            read_turn(site, "rpyOffset", parameters.rpy_offset),
        )
        self._last_ns = site.now_ns
        self._covariance = diagonal_covariance((parameters.gaussian_noise**2,) * 6)
        self._period_ns = round(1e9 / parameters.update_rate) if parameters.update_rate else 0

    def on_attach(self) -> None:
        """Advertise."""
        site = self.site
        self._message = odometry_message(
            Frames(
                parent=resolve_frame(self.parameters.frame_name, tf_prefix(site)), child=self._body
            ),
            Covariances(pose=self._covariance, twist=self._covariance),
        )
        self._publisher = site.node.advertise(self._topic, message_class("nav_msgs/Odometry"))
        self._begin()

    @property
    def due_ns(self) -> int:
        """Each period, if someone listens."""
        return self._last_ns + self._period_ns if self._publisher.num_connections else NEVER

    def after_step(self) -> None:
        """Publish, if it is time and somebody listens."""
        now = self.site.now_ns
        if now - self._last_ns >= self._period_ns and self._publisher.num_connections:
            self._publisher.publish(self._measured())
            self._last_ns = now

    def on_reset(self) -> None:
        """Count its period anew, and draw the same noise again."""
        self._begin()

    def on_detach(self) -> None:
        """Withdraw."""
        self._publisher.unregister()

    # -- private

    def _begin(self) -> None:
        self._last_ns = self.site.now_ns
        self._random = generator(self.site.seed("p3d", self.site.name))

    def _link(self, name: str, link: str) -> str:
        known = self.site.model.links
        if link in known:
            return link
        element = self.site.element.child(name) or self.site.element
        near = near_names(link, known)
        hint = f"; did you mean {near[0]}?" if near else ""
        raise PluginError(
            f"{self.site.place(element)}: gazebo_ros_p3d plugin error: {name}: {link} does not exist"
            f"{hint} Links of {self.site.model.name}: {', '.join(known) or 'none'}."
        )

    def _measured(self) -> Any:
        message = self._message
        message.header.stamp = self.site.node.now()
        pose, linear, angular = self._seen()
        set_pose(message.pose.pose, pose)
        twist = message.twist.twist
        twist.linear.x, twist.linear.y, twist.linear.z = self._noisy(linear)
        twist.angular.x, twist.angular.y, twist.angular.z = self._noisy(angular)
        return message

    def _seen(self) -> tuple[Transform, Vector, Vector]:
        """Pose and velocities, seen from the frame, with the offsets."""
        model = self.site.model
        pose, (linear, angular) = model.link_pose(self._body), model.link_twist(self._body)
        back = conjugate(pose.rotation)
        if self._reference is not None:
            seen_from = model.link_pose(self._reference)
            frame_linear, frame_angular = model.link_twist(self._reference)
            pose = _seen_from(seen_from, pose)
            # Into the frame it should be the other way round; Gazebo turns them so.
            linear = rotate(seen_from.rotation, _minus(linear, frame_linear))
            angular = rotate(seen_from.rotation, _minus(angular, frame_angular))
        if self.parameters.local_twist:
            linear, angular = rotate(back, linear), rotate(back, angular)
        x, y, z = pose.translation
        dx, dy, dz = self._offset.translation
        rotation = multiply(self._offset.rotation, pose.rotation)
        return Transform((x + dx, y + dy, z + dz), rotation), linear, angular

    def _noisy(self, velocity: Vector) -> Vector:
        scale = self.parameters.gaussian_noise
        if scale == 0.0:
            return velocity
        x, y, z = (v + scale * float(self._random.standard_normal()) for v in velocity)
        return (x, y, z)


def _seen_from(frame: Transform, pose: Transform) -> Transform:
    """A pose as Gazebo sees it from a frame: its rotations are the wrong way round, unless they commute."""
    back = conjugate(frame.rotation)
    position = rotate(back, _minus(pose.translation, frame.translation))
    return Transform(position, multiply(pose.rotation, back))


def _minus(one: Vector, other: Vector) -> Vector:
    return (one[0] - other[0], one[1] - other[1], one[2] - other[2])
