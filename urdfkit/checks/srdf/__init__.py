"""SRDF: MoveIt's groups, states and allowed-collision matrix."""

from __future__ import annotations

from urdfkit.lint.context import Context
from urdfkit.workspace.siblings import other_srdf_files, srdf_files


def applies(subject: Context) -> bool:
    """True if an SRDF of this robot is near it."""
    path = subject.source.path
    is_there = srdf_files(path, subject.resolver) or other_srdf_files(
        path, subject.model.name, subject.resolver
    )
    return bool(is_there) and not subject.other_variant
