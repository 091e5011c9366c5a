"""Mesh files: detected, validated and loaded, a format at a time."""
