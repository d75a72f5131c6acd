"""The programs of the package controller_manager: they talk with the controller manager of a robot.

The manager itself lives in the plugin `libgazebo_ros_control.so`.
`services` knows the manager's services, and why there are none.
"""
