"""Widgets of a notebook that move a robot by hand: a teleop pad, and sliders for a trajectory controller.

`notebook_widgets` is what they share; `drive_keys` are the keys of the `teleop_pad`, `controlled_joints` the
joints of the `trajectory_sliders`.
"""
