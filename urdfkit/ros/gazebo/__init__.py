"""Gazebo: what it makes of a robot, its plugins and its sensors."""
