"""One model of what is seen in 3D: a scene of frames, solids and marks before a camera.

Read it in this order: `frames`, `parts` (what there is), `scene` (all of that at one moment), `camera`.
Scenes come from three sources: tf and robots (`robot`, `rviz_source`), topics (`topic_listener`, `topic_marks`), and
worlds of Gazebo (`world_models`, `world_bodies`, `world_scene`, `world_source`). Nothing here draws.
"""
