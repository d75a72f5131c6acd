"""The window of turtlesim to look at.

`picture` is one moment, `replay` plays a `tape`, `page` is live in a browser; `view` offers them.
"""
