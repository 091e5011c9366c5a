"""Gazebo plugins: libraries, parameters, the links and joints that they refer to."""

from __future__ import annotations

from urdfkit.lint.context import Subject

#: Codes and names of rules that others have absorbed.
REDIRECTS = {
    "GAZ035": "GAZ011", "plugin-class-unknown": "GAZ011", "GAZ070": "GAZ011",
    "plugin-misspelt": "GAZ011",
    "GAZ013": "GAZ012", "mixed-generations": "GAZ012",
    "GAZ015": "GAZ014", "plugin-in-wrong-sensor": "GAZ014", "GAZ033": "GAZ014",
    "world-system-in-model": "GAZ014",
    "GAZ018": "GAZ016", "parameter-of-other-generation": "GAZ016", "GAZ032": "GAZ016",
    "misspelt-parameter": "GAZ016", "unknown-parameter": "GAZ016",
    "GAZ020": "GAZ021", "parameter-names-unknown-link": "GAZ021", "GAZ022": "GAZ021",
    "names-merged-link": "GAZ021", "GAZ023": "GAZ021", "names-dropped-link": "GAZ021",
    "parameter-names-unknown-joint": "GAZ021",
}  # fmt: skip


def applies(subject: Subject) -> bool:
    """True if a ``<gazebo>`` element holds a plugin."""
    return bool(subject.plugins)
