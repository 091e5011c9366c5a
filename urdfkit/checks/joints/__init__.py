"""Joints: types, axes, limits."""
