"""Motors that give all they have, and do not get there."""

from __future__ import annotations

from simkit.gazebo.watching.watcher import Finding, Scene, Watcher
from simkit.physics import Mode, ModelJoint

PATIENCE = 6
"""So many looks in a row, which is more than half a second."""
STANDING = 0.01
"""What is slower [rad/s or m/s] stands."""


class WeakJoints(Watcher):
    """Looks at the joints that are driven."""

    rule = "GZ-W04"
    is_said_by_rule = True

    def __init__(self, scene: Scene) -> None:
        super().__init__(scene)
        self._looks: dict[str, int] = {}

    @classmethod
    def is_for(cls, scene: Scene) -> bool:
        """Whether it has joints, and plugins that may drive them."""
        return bool(scene.spawned.plugins and scene.model.joints)

    def look(self) -> Finding | None:
        """Whether a motor has been at its bound for too long."""
        for name, joint in self.model.joints.items():
            if joint.mode in (Mode.FREE, Mode.POSITION):
                continue
            looks = self._looks.get(name, 0) + 1 if joint.is_saturated and _is_late(joint) else 0
            self._looks[name] = looks
            if looks >= PATIENCE:
                return Finding(text=self._text(joint))
        return None

    def _text(self, joint: ModelJoint) -> str:
        is_turning = joint.plan.kind.value == "revolute"
        effort, speed = ("N m", "rad/s") if is_turning else ("N", "m/s")
        does = f"moves at {joint.velocity:.2g} {speed}"
        if joint.mode is Mode.VELOCITY:
            does += f" instead of {joint.command:.2g} {speed}"
        drive = self.scene.drive
        is_wheel = drive is not None and joint.name in {one.name for one in drive.joints}
        where = (
            f"<{drive.torque_tag}>" if drive is not None and is_wheel else '<limit effort="...">'
        )
        return (
            f"the joint {joint.name!r} of {self.model.name} has given all it has for half a second, "
            f"{abs(joint.effort):.3g} {effort}, and {does}: it is too weak, or something holds it. Give it more in "
            f"{where}, or look for friction in its <dynamics>, and for what is in its way"
        )


def _is_late(joint: ModelJoint) -> bool:
    """Whether it is far from what it shall do."""
    if joint.mode is Mode.VELOCITY:
        return abs(joint.velocity - joint.command) > max(0.5 * abs(joint.command), STANDING)
    at_stop = min(joint.position - joint.plan.lower, joint.plan.upper - joint.position) < 1e-3
    return abs(joint.velocity) < STANDING and not at_stop
