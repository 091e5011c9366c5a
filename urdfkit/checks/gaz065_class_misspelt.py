"""The class of a gz-sim plugin is misspelt.

gz-sim loads from the library the class that the `name` says, and finds none: "Failed to load system
plugin". Only slips of the library's own classes are told.

Sources:
    gz-sim, SystemLoader.cc: https://github.com/gazebosim/gz-sim/blob/main/src/SystemLoader.cc
"""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.diagnostic import Fix, Severity
from urdfkit.editing.edits import replace_value
from urdfkit.nearest import nearest
from urdfkit.rules import Finding, Need, rule
from urdfkit.static import TYPE_CHECKING

if TYPE_CHECKING:
    from urdfkit.subject import Subject

BAD = """\
<link name="base">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<gazebo>
  <plugin name="gz::sim::systems::JointStatePublsher"
          filename="gz-sim-joint-state-publisher-system"/>
</gazebo>"""
FIXED = GOOD = BAD.replace("Publsher", "Publisher")

#: Older names, which gz-sim takes as well.
_ALIASES = (("ignition::gazebo::", "gz::sim::"), ("ign_ros2_control::", "gz_ros2_control::"))
_SLIP = 0.85


@rule("GAZ065", "class-misspelt", Severity.ERROR, needs=(Need.MODEL, Need.GAZEBO), fixable=True)
def check(subject: Subject) -> Iterator[Finding]:
    for use in subject.plugins:
        classes = {
            name
            for plugin in use.known
            for name in (plugin.class_name, plugin.fortress_class)
            if plugin.generation == "gz" and name
        }
        name = use.at.attributes.get("name")
        if name is None or not classes or not _is_strange(name.value, classes):
            continue
        meant = nearest(name.value, classes, _SLIP)
        if meant:
            edits = replace_value(name, meant)
            fix = Fix(f"write {meant}", edits) if edits else None
            message = f"library {use.filename} has no class '{name.value}'"
            yield Finding(name, message, f"did you mean '{meant}'?", fix)


def _is_strange(name: str, classes: set[str]) -> bool:
    for old, new in _ALIASES:
        if name.startswith(old):
            name = new + name.removeprefix(old)
    known = {new + one.removeprefix(old) for one in classes for old, new in _ALIASES}
    return name not in classes | known
