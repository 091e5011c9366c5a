"""SRDF: MoveIt's groups, states and allowed-collision matrix."""

from __future__ import annotations

from urdfkit.lint.context import Subject
from urdfkit.workspace.siblings import other_srdf_files, srdf_files

#: Former codes and names of rules.
REDIRECTS = {
    "SRD023": "SRD001", "solver-misspelt": "SRD001", "SRD012": "SRD001", "SRD014": "SRD001",
    "SRD019": "SRD001", "SRD020": "SRD001", "SRD021": "SRD001", "unknown-link-in-matrix": "SRD001",
    "joint-limits-of-unknown-joint": "SRD001", "state-joint-not-in-group": "SRD001",
    "settings-of-unknown-group": "SRD001", "controller-settings-unknown": "SRD001",
    "SRD002": "SRD003", "chain-not-a-path": "SRD003", "SRD013": "SRD003", "group-empty": "SRD003",
    "group-cycle": "SRD003",
    "SRD024": "SRD004", "state-twice": "SRD004", "SRD005": "SRD004",
    "state-outside-limits": "SRD004", "state-sets-immovable-joint": "SRD004",
    "SRD008": "SRD010", "matrix-out-of-date": "SRD010", "reason-adjacent-untrue": "SRD010",
    "SRD022": "SRD015", "joint-limits-wider-than-robot": "SRD015", "joint-limit-refused": "SRD015",
    "SRD016": "SRD017", "SRD018": "SRD017", "incomplete-element": "SRD017",
    "misspelt-name": "SRD017", "unreadable": "SRD017",
}  # fmt: skip


def applies(subject: Subject) -> bool:
    """True if an SRDF of this robot is near it."""
    path = subject.source.path
    is_there = srdf_files(path, subject.resolver) or other_srdf_files(
        path, subject.model.name, subject.resolver
    )
    return bool(is_there) and not subject.other_variant
