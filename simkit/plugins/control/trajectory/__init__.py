"""Trajectories of joints, and the controller that follows them.

`segment` has the motion of one joint, `command` what is asked for, `replacement` makes one trajectory of
the running one and a new command. `controller` is the JointTrajectoryController, with `settings` (its
parameters) and `goals` (its action).
"""
