"""Simulations of the robot in MuJoCo, which a check makes only if it is asked to (--simulate)."""
