"""Recordings as figures: joints, how a controller tracks, ways over the ground.

`plot` is what all figures share, `recorded` finds their topics; `*_series` are the numbers and `*_plot` the
figures. `model_recording` records what no topic tells.
"""
