"""Gazebo: what it makes of a robot, its plugins and its sensors."""

#: In the messages of rules that have milder findings, too; `rejection` recognises them.
REJECTED, REJECTED_BY_GZ = "Gazebo rejects the model", "gz-sim rejects the model"
