"""Mesh files: judged from their bytes, without a mesh library."""
