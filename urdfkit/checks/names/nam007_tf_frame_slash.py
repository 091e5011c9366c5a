"""The name of a link begins with a slash.

Links become frames of TF, and since tf2 a frame must not begin with `/`: every look-up of it fails,
and `/base_link` and `base_link` are two frames. ROS 1's first TF allowed it. Leave the slash out.

Sources:
    tf2, migration: http://wiki.ros.org/tf2/Migration
    robot_state_publisher: https://github.com/ros/robot_state_publisher/blob/rolling/src/robot_state_publisher.cpp
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = '<link name="/base_link"/>'
GOOD = '<link name="base_link"/>'


@rule(
    "NAM007",
    "tf-frame-slash",
    Severity.WARNING,
    help="leave the slash out, here and in every place that names the link",
)
def check(subject: Subject) -> Iterator[Finding]:
    for link in subject.model.links:
        if link.name.startswith("/"):
            yield Finding(
                link.at.attributes["name"],
                f"link '{link.name}': tf2 refuses frames that begin with '/'",
            )
