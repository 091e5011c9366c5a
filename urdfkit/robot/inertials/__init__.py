"""Declared masses and inertia tensors, compared with those of shapes; corrections."""
