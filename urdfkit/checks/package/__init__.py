"""The ROS package of a robot or a launch file: dependencies, declarations, installed files."""
