"""Whether an SRDF is for the robot."""
