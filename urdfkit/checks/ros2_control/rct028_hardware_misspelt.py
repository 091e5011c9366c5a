"""The class of a hardware plugin is nearly one that ros2_control or a simulator has.

The class loader finds no plugin of that name, and the controller manager starts without hardware.
Classes that urdfkit does not know are taken to be the robot's own.

Sources:
    ros2_control, resource_manager.cpp: https://github.com/ros-controls/ros2_control/blob/master/hardware_interface/src/resource_manager.cpp
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.core.suggest import nearest
from urdfkit.lint.rules import Finding, rule
from urdfkit.ros.catalog.ros_control import hardware
from urdfkit.ros.ros_control import components
from urdfkit.text.diagnostic import Fix, Severity
from urdfkit.text.editing.edits import rewrite

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="base"/>
<link name="arm"/>
<joint name="shoulder" type="revolute">
  <parent link="base"/>
  <child link="arm"/>
  <axis xyz="0 0 1"/>
  <limit lower="-1" upper="1" effort="10" velocity="1"/>
</joint>
<ros2_control name="arm" type="system">
  <hardware>
    <plugin>mock_component/GenericSystem</plugin>
  </hardware>
  <joint name="shoulder">
    <command_interface name="position"/>
    <state_interface name="position"/>
  </joint>
</ros2_control>"""
GOOD = BAD.replace("mock_component/", "mock_components/")
FIXED = GOOD

#: Of ros2_control itself, and of a package that many simulators are driven through.
_COMMON = ("mock_components/GenericSystem", "topic_based_ros2_control/TopicBasedSystem")
_TYPO = 0.9


@rule("RCT028", "hardware-misspelt", Severity.ERROR, fixable=True)
def check(subject: Subject) -> Iterator[Finding]:
    known = (*_COMMON, *hardware())
    for component in components(subject.model):
        name = component.hardware
        suggested = _suggested(name, known) if name and name not in known else None
        if component.plugin and suggested and not name.startswith("fake_"):
            edits = rewrite(component.plugin, suggested)
            fix = Fix.of(f"write {suggested}", edits)
            message = f"{component.called}: hardware '{name}' is nearly '{suggested}'"
            yield Finding(component.plugin, message, f"write {suggested}", fix)


def _suggested(name: str, known: tuple[str, ...]) -> str | None:
    """The class that a name is a slip of, or that it is without its package."""
    full = (one for one in known if one.endswith(f"/{name}"))
    return next(full, None) or nearest(name, known, _TYPO)
