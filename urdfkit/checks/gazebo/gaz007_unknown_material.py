"""Gazebo does not have the material, or does not draw it.

`<material>` in a `<gazebo>` block refers to a script of Gazebo, such as `Gazebo/Orange`: with the
prefix, and case-sensitive. Gazebo Classic draws an unknown name white or as an error, and gz-sim
falls back to the colour of the URDF. Materials that a `*.material` file of the workspace defines
are not reported, unless the robot is for gz-sim.

Gazebo Fortress has no material scripts at all, and from Garden on gz-sim substitutes the plain
colours by name but draws no texture: an info. For these, give the colour in the URDF's `<material>`
or as `<visual><material><diffuse>` in the `<gazebo>` block.

Sources:
    Gazebo Classic, URDF: https://classic.gazebosim.org/tutorials?tut=ros_urdf
    gz-sim, migration of materials: https://github.com/gazebosim/gz-sim/blob/main/tutorials/migration_sdf.md
    sdformat, parser_urdf.cc: https://github.com/gazebosim/sdformat/blob/main/src/parser_urdf.cc
"""

import re

from urdfkit.core.suggest import Suggester
from urdfkit.lint.rules import Context, Finding, Findings, Fix, Severity, rule
from urdfkit.robot.samples import robot_xml
from urdfkit.ros.catalog.materials import materials
from urdfkit.ros.gazebo.samples import gazebo_xml, solid_xml
from urdfkit.ros.targets import GZ, Targets
from urdfkit.text.document import Element
from urdfkit.text.editing.edits import replace_text
from urdfkit.workspace.file_head import read_head

BAD = robot_xml(solid_xml("wheel"), gazebo_xml("<material>Orange</material>", reference="wheel"))
FIXED = GOOD = BAD.replace("Orange", "Gazebo/Orange")

#: Directories of a workspace that are searched for material scripts.
_MAX_DIRECTORIES = 2000
_MATERIAL = rb"(?m)^[ \t]*material[ \t]+\"?([^\s\"{:]+)"


@rule(
    Severity.WARNING,
    help="use one of Gazebo's materials, or give the colour in the URDF's <material>",
)
def check(context: Context) -> Findings:
    known = materials()
    # By their last words: all begin with "Gazebo/", which would make them alike.
    bare = {name.rpartition("/")[2]: name for name in known if not known[name].internal}
    suggester = Suggester(bare)
    scripted: set[str] | None = None  # not known
    of_links = (block for block in context.model.gazebo if block.get("reference"))
    for child in (child for block in of_links for child in block.all("material")):
        name = child.get("value") or child.text.strip()
        if name in known:
            if message := _without_effect(name, known[name].is_textured, context.targets):
                yield Finding(child, message, severity=Severity.INFO)
        # Another prefix is that of a vendor's own scripts.
        elif "/" not in name or name.lower().startswith("gazebo/"):
            if scripted is None:
                scripted = set() if context.targets.any_of(GZ) else _scripted(context)
            if name not in scripted:
                suggested = suggester.suggested(name.rpartition("/")[2])
                yield _finding(child, name, bare.get(suggested, ""))


def _without_effect(name: str, is_textured: bool, targets: Targets) -> str:
    """What new versions of Gazebo do not draw of a material of Gazebo Classic; empty if nothing."""
    if targets.any_of(("gz-fortress",)):
        return f"material '{name}' has no effect in Gazebo Fortress"
    if is_textured and targets.any_of(("gz-harmonic", "gz-jetty")):
        return f"gz-sim does not draw the texture of material '{name}'"
    return ""


def _scripted(context: Context) -> set[str]:
    """The materials that the material scripts of Ogre in the workspace define."""
    root = context.resolver.packages.workspace(context.source.path)
    return {
        name.decode("utf-8", "replace")
        for file in context.resolver.directories.files_below(root, _MAX_DIRECTORIES)
        if file.endswith(".material") and context.resolver.allows(file, context.source.path)
        for name in re.findall(_MATERIAL, read_head(file))
    }


def _finding(child: Element, name: str, right: str) -> Finding:
    if child.children and not name:
        message = f"Gazebo ignores <{child.children[0].tag}> in <material>, which names a material"
        return Finding(child, message, "write <visual><material>...</material></visual>")
    edits = replace_text(child, right) if right and not child.get("value") else None
    message = f"unknown Gazebo material '{name}'" if name else "<material> is empty"
    help = f"did you mean '{right}'?" if right else ""
    return Finding(child, message, help, Fix.of(f"write {right}", edits), group_key=name)
