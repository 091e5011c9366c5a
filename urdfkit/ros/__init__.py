"""What ROS, Gazebo and MoveIt make of a robot, and the files that they read."""
