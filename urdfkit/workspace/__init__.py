"""The workspace around a robot: packages and files that belong to it, without ROS."""
