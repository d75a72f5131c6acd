"""Simulations at the pace of the wall clock, which several terminals share.

`host` runs one, `session` is how terminals find it, and `client` what they say to it.
"""
