"""Whether the SRDF near a robot is that of this robot."""

from __future__ import annotations

from urdfkit.lint.context import Context
from urdfkit.workspace.siblings import other_srdf_files, srdf_files


def applies(subject: Context) -> bool:
    """True if an SRDF is near the robot."""
    path = subject.source.path
    return bool(
        srdf_files(path, subject.resolver)
        or other_srdf_files(path, subject.model.name, subject.resolver)
    )
