"""The ``<gazebo>`` elements: references, tags, materials, frames."""

from __future__ import annotations

from urdfkit.lint.context import Subject

#: Codes and names of rules that others have absorbed.
REDIRECTS = {
    "GAZ042": "GAZ003", "sensor-child-unknown": "GAZ003",
    "bad-value": "GAZ004", "GAZ019": "GAZ004", "parameter-bad-type": "GAZ004", "GAZ046": "GAZ004",
    "lidar-range-inverted": "GAZ004", "GAZ048": "GAZ004", "camera-clip-inverted": "GAZ004",
    "GAZ057": "GAZ004", "sensor-value-refused": "GAZ004",
    "GAZ002": "GAZ005", "link-tag-without-reference": "GAZ005", "tag-on-wrong-kind": "GAZ005",
    "GAZ008": "GAZ007", "material-without-effect": "GAZ007",
    "plugin-without-name-or-filename": "GAZ010", "GAZ034": "GAZ010",
    "plugin-name-is-no-node-name": "GAZ010", "GAZ060": "GAZ010", "sensor-without-name": "GAZ010",
    "duplicate-plugin-name": "GAZ010", "GAZ061": "GAZ010", "duplicate-sensor-name": "GAZ010",
    "GAZ027": "GAZ010", "duplicate-plugin-or-sensor-name": "GAZ010",
    "GAZ053": "GAZ058", "frame-id-missing": "GAZ058", "frame-unknown": "GAZ058",
    "GAZ052": "GAZ067", "force-torque-on-fixed-joint": "GAZ067", "GAZ066": "GAZ067",
    "preserved-link-without-mass": "GAZ067", "flag-spreads-to-parent": "GAZ067", "GAZ068": "GAZ067",
    "tags-lost-on-shape": "GAZ067", "GAZ069": "GAZ067", "lumping-disabled-by-a-joint": "GAZ067",
}  # fmt: skip


def applies(subject: Subject) -> bool:
    """True if there are ``<gazebo>`` elements."""
    return bool(subject.model.gazebo)
