"""Wheels and drives: the Gazebo plugins and controllers that turn joints."""
