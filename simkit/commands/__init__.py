"""The command lines of ROS, each one function `(simulation, words) -> lines`, registered in `table`.

A terminal (`simkit.cli`), the simulation that terminals share (`simkit.live`), the lines of a notebook
(`simkit.notebook`) and Python (`table.run_command`) are fronts: they differ in who lets time pass, and where texts go.
`command` is what a command and its front say to each other.
"""
