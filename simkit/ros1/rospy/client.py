"""`rospy.client`: some scripts reach for names here."""

from .core import init_node, myargv, spin

__all__ = ["init_node", "myargv", "spin"]
