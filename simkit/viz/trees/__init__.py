"""Trees as pictures: the frames of TF (`frames`, of the trees that `forest` finds) and a robot (`robot`).

`layout` finds a place for everything, `drawing` draws it.
"""
