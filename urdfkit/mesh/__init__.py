"""Mesh files and triangles: read, validated, measured, repaired, simplified, written."""
