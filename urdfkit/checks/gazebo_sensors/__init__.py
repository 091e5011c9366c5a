"""Sensors of Gazebo: types, rates, ranges, frames."""
