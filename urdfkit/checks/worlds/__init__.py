"""The worlds of Gazebo that launch files start."""
