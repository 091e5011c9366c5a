"""Controllers of ros2_control: their parameter files."""
