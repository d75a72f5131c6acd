"""What the checks of this course compare with: motions on paper, and measurements of a student's robot.

The checks of any exercise may import a module of this folder by `from oracles.arm import ...`; what is not about
the exercises of this course (fixtures, expectations, robots, worlds) is in `grader.checks`.
"""
