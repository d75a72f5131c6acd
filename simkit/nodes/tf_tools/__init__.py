"""The programs of the packages tf, tf2_ros and tf2_tools, as nodes in this process.

Each prints what its original prints; `output` holds it. A program that cannot start with its
command line prints why, leaves the graph, and has an `exit_code`.
"""
