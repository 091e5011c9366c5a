"""Dynamics: gravity torques, stability, the mass matrix."""
