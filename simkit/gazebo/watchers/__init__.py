"""What a teacher would say while a simulation runs: each thing once, with numbers and the remedy.

`watch(gazebo)` looks at each model that is spawned, ten times a second of virtual time, and speaks
through the node `/gazebo`. It changes nothing. What `check_urdf` warns of when a robot is spawned is not
said again. Read `scene`, then `watch`.
"""

from simkit.gazebo.watchers.watch import Watch, watch

__all__ = ["Watch", "watch"]
