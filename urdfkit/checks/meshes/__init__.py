"""Mesh files that a robot refers to: whether programs find them."""
