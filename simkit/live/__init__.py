"""A simulation that lives in one terminal and is used from others, paced by the wall clock.

`host` runs it; `session` is how other terminals find it; `client` is what they say to it; `job` is a command at work.
Same events, same order as `sim.run`: only waiting is added.
"""

from simkit.live.client import call
from simkit.live.host import Host
from simkit.live.job import Job
from simkit.live.session import Session, SessionError, find_session

__all__ = [
    "Host",
    "Job",
    "Session",
    "SessionError",
    "call",
    "find_session",
]
