"""The window of turtlesim to look at.

`picture` is one moment, `replay` plays what happened; `view` offers them, and follows what happens.
"""
