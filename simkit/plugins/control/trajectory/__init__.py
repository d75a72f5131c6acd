"""Trajectories of joints, and the controller that follows them.

Without ROS are `spline` (one polynomial), `segment` (one with a time and a goal), `tolerances`, `command`
(what is asked for), `replacement` (a running trajectory and a new command become one) and `stopping`.
`controller` is the JointTrajectoryController, with `adapter` (how it moves the joints), `settings`,
`reading` (messages) and `goals` (its action).
"""
