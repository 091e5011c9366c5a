"""The workspace of a robot: its packages and files, found without ROS."""
