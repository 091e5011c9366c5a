"""Wheels and drives: the Gazebo plugins and controllers that turn joints."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

#: Former codes and names of rules.
REDIRECTS = {
    "GAZ064": "GAZ024", "wheel-driven-twice": "GAZ024", "joint-kind-unfit": "GAZ024",
    "driven-by-nothing": "GAZ029",
    "wheel-numbers-disagree": "RCT014", "GAZ025": "RCT014", "wheel-geometry-disagrees": "RCT014",
    "drive-sides-swapped": "RCT025", "GAZ026": "RCT025", "left-and-right-swapped": "RCT025",
    "JNT043": "RCT025", "wheel-axis-reversed": "RCT025", "wheel-against-the-others": "RCT025",
    "JNT044": "RCT025", "wheels-against-each-other": "RCT025",
    "odometry-frame-unknown": "RCT029", "GAZ031": "RCT029", "odometry-frame-is-not-root": "RCT029",
}  # fmt: skip


def applies(subject: Subject) -> bool:
    """True if there are wheels, plugins of Gazebo or parameter files of controllers."""
    model = subject.model
    names = [*(link.name for link in model.links), *(joint.name for joint in model.joints)]
    has_wheels = any("wheel" in name.lower() for name in names)
    return has_wheels or bool(subject.parameters) or bool(model.gazebo and subject.plugins)
