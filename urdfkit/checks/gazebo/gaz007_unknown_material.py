"""Gazebo has no material of that name.

`<material>` in a `<gazebo>` block names a script of Gazebo, such as `Gazebo/Orange`: with the
prefix, and with capitals where it has them. Gazebo Classic draws an unknown name white or as an
error, and gz-sim falls back to the colour of the URDF.

Sources:
    Gazebo Classic, URDF: https://classic.gazebosim.org/tutorials?tut=ros_urdf
    gz-sim, migration of materials: https://github.com/gazebosim/gz-sim/blob/main/tutorials/migration_sdf.md
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.core.suggest import Suggester
from urdfkit.lint.rules import Finding, rule
from urdfkit.ros.catalog.materials import materials
from urdfkit.text.diagnostic import Fix, Severity
from urdfkit.text.editing.edits import replace_text

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.text.document import Element

BAD = """\
<link name="wheel">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<gazebo reference="wheel">
  <material>Orange</material>
</gazebo>"""
GOOD = BAD.replace("Orange", "Gazebo/Orange")
FIXED = GOOD


@rule(
    "GAZ007",
    "unknown-material",
    Severity.WARNING,
    fixable=True,
    help="take one of Gazebo's own materials, or give the colour in the URDF",
)
def check(subject: Subject) -> Iterator[Finding]:
    known = materials()
    # By their last words: all begin with "Gazebo/", which would make them alike.
    bare = {name.rpartition("/")[2]: name for name in known if not known[name].internal}
    suggester = Suggester(bare)
    for block in subject.model.gazebo:
        for child in block.all("material") if block.get("reference") else ():
            name = child.get("value") or child.text.strip()
            # Another prefix is that of a vendor's own scripts.
            if name not in known and ("/" not in name or name.lower().startswith("gazebo/")):
                suggested = suggester.suggested(name.rpartition("/")[2])
                yield _finding(child, name, bare.get(suggested, ""))


def _finding(child: Element, name: str, right: str) -> Finding:
    edits = replace_text(child, right) if right and not child.get("value") else None
    return Finding(
        child,
        f"Gazebo has no material '{name}'" if name else "<material> names no material",
        f"did you mean '{right}'?" if right else "",
        Fix.of(f"write {right}", edits),
        alike=name,
    )
