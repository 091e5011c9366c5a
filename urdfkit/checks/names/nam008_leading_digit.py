"""A name begins with a digit.

URDF, ROS and Gazebo take it, USD does not: Isaac Sim renames such links and joints, so that a
script no longer finds them, and older importers fail. Put a letter first.

Sources:
    Isaac Sim, URDF importer: https://docs.isaacsim.omniverse.nvidia.com/latest/robot_setup/ext_isaacsim_asset_importer_urdf.html
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = '<link name="2nd_arm"/>'
GOOD = '<link name="arm_2"/>'


@rule(
    "NAM008",
    "leading-digit",
    Severity.INFO,
    help="put a letter first",
    by_target={"isaac": Severity.WARNING},
)
def check(subject: Subject) -> Iterator[Finding]:
    for name in subject.model.names:
        if "0" <= name.value[:1] <= "9":
            message = f"{name.element.tag} '{name.value}' begins with a digit"
            yield Finding(name, f"{message}, which USD does not allow")
