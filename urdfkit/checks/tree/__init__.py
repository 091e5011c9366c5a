"""The kinematic tree."""
