"""Widgets of a notebook, over its own channel: no port is opened.

`scene_widget` shows a scene that moves; a teleop pad and sliders for joints and for a trajectory controller move a
robot by hand, beside it. A `panel` is what the latter share: it talks with its script in the browser.
"""
