"""A mesh has the wrong scale: its size is that of another unit.

Lengths in URDF are in metres. A part of 300 mm that a CAD program exports in millimetres becomes
300 m long: RViz shows only its inside, the robot collides with everything, and planners find no
path. Add `scale="0.001 0.001 0.001"` to the `<mesh>`, or export the mesh in metres. A mesh is
reported if it is more than 10 m long, and 20 times as long as joints and primitives of the robot.

The opposite is a mesh in metres with a scale for millimetres: a part of 0.2 m becomes 0.2 mm long,
too small to see or to touch. The attribute was copied from a mesh that needs it, or the mesh was
exported again in metres. The mesh is reported if a scale of 0.01 or less makes it shorter than
1 mm.

Sources:
    REP 103, units and axes: https://www.ros.org/reps/rep-0103.html
    URDF, link: https://wiki.ros.org/urdf/XML/link
"""

from urdfkit.core.words import spaced
from urdfkit.lint.rules import Confidence, Context, Finding, Findings, Fix, Need, Severity, rule
from urdfkit.mesh.samples import box, stl
from urdfkit.robot.assets.mesh_defects import MeshDefect, rest_of_robot
from urdfkit.robot.assets.mesh_uses import MeshUse
from urdfkit.robot.samples import joint_xml, link_xml, robot_xml, visual_xml
from urdfkit.text.document import Attribute
from urdfkit.text.editing import edits

BAD = robot_xml(
    link_xml("base"),
    link_xml("arm", visual_xml('<mesh filename="forearm.stl"/>')),
    joint_xml("continuous", '<origin xyz="0 0 0.2"/>', '<axis xyz="0 0 1"/>'),
)
FIXED = GOOD = BAD.replace(
    'filename="forearm.stl"', 'filename="forearm.stl" scale="0.001 0.001 0.001"'
)
FILES = {"forearm.stl": stl(box((0, 0, 0), (80, 60, 300)))}


@rule(
    Severity.WARNING,
    needs=(Need.MODEL, Need.MESHES),
    help='add scale="0.001 0.001 0.001" to the mesh, or export it in metres',
)
def check(context: Context) -> Findings:
    defects = context.measured.defects
    for use in defects.get(MeshDefect.MILLIMETRES, ()):
        length = use.longest
        message = (
            f"{use.who} is {length:.4g} m long, the rest of the robot "
            f"{rest_of_robot(context.model):.3g} m; in mm it would be {length / 1000:.3g} m"
        )
        yield Finding(use.at, message, fix=_fix(use), confidence=Confidence.INFERRED, weight=length)
    for use in defects.get(MeshDefect.MICROSCOPIC, ()):
        unscaled = use.longest / max(map(abs, use.shape.scale))
        yield Finding(
            use.scale_at or use.at,
            f"{use.who} is {1000 * use.longest:.2g} mm long by its scale, and {unscaled:.3g} m "
            "without it",
            "remove the scale, or correct it",
            confidence=Confidence.INFERRED,
            group_key="scale",
        )


def _fix(use: MeshUse) -> Fix | None:
    """Writes a thousandth of the scale, if the file name is written in the source."""
    name = use.at.at
    if not isinstance(name, Attribute) or not name.literal:
        return None
    scale = spaced((factor * 0.001 for factor in use.shape.scale), 9)
    written = use.scale_at
    if written is not None:
        change = edits.replace_value(written, scale) if written.literal else None
    else:
        change = edits.add_attribute(name, "scale", scale)
    return Fix.of(f'write scale="{scale}"', change)
