"""The modules that a student's script imports: rospy, tf, the message packages.

This folder lies on the import path of node processes only, so that `import rospy` there finds `ros1/rospy`.
"""
