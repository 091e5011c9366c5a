"""Mesh files that a robot names: whether they exist."""

from __future__ import annotations

from urdfkit.lint.context import Subject

#: Former codes and names, and the rules that report their findings now.
REDIRECTS = {
    "MSH025": "MSH003", "mesh-not-tracked": "MSH003",
    "MSH002": "MSH001", "case-mismatch": "MSH001", "MSH004": "MSH001", "backslash-path": "MSH001",
    "MSH036": "MSH001", "unknown-scheme": "MSH001",
    "absolute-path": "MSH003", "MSH006": "MSH003", "path-escapes-package": "MSH003",
}  # fmt: skip


def applies(subject: Subject) -> bool:
    """True if a shape is a mesh file."""
    return any(shape.filename for shape in subject.model.shapes)
