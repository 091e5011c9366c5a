"""Gravity loads, dynamics by Pinocchio, self-collisions by coal, and poses."""
