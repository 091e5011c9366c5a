"""Gazebo plugins: libraries, parameters, the links and joints that they refer to."""
