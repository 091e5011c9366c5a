"""Shapes and colours of visuals and collisions."""
