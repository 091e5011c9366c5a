"""Masses and inertia tensors as declared, beside those of shapes; what was meant."""
