"""Widgets of a notebook that move a robot by hand: a teleop pad, sliders for joints and for a trajectory controller.

A `panel` is what they share: it talks with its script in the browser over the notebook's own channel.
"""
