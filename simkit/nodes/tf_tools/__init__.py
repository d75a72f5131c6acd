"""The programs of the packages tf, tf2_ros and tf2_tools, as nodes in this process.

Each prints what its original prints; `output` holds it. A program that its command line keeps from
starting says so, leaves the graph, and has an `exit_code`.
"""
