"""Launch files."""
