"""Recordings as figures: `joints` and how a controller tracks, `paths` over the ground, `transforms`.

`plot` is what all figures share; `model_recording` records what no topic has.
"""
