"""Displays of RViz that show the messages of topics: laser scans, odometry, paths.

Read it in this order: `displays` (what is set), `config` (the same in a `.rviz` file), `laser_points` and
`topic_marks` (what a message looks like), `display_ear` (which messages have a place by now), `ears` (for
views), `topic_tape` (for replays).
"""
