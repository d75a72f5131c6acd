"""ros_control in the simulation: the plugin that lets controllers move the joints of a robot.

Read it in this order: `plugin` (what happens in a step), `transmission` (which joints, by which
interface), `joint_drive` (how a command becomes a motion), `manager` (who loads, starts and stops
controllers), `controller` (what one is), `registry` (which types there are); then `joint_command`,
`joint_state` and `trajectory`. Without ROS are `angles`, `limits` and `pid`.
"""
