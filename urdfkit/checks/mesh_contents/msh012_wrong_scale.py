"""A mesh has the wrong scale: its size is that of another unit.

Lengths in URDF are in metres. A part of 300 mm that a CAD program exports in millimetres becomes
300 m long: RViz shows only its inside, the robot collides with everything, and planners find no
path. Add `scale="0.001 0.001 0.001"` to the `<mesh>`, or export the mesh in metres. A mesh is
reported if it is more than 10 m long, and 20 times as long as joints and primitives of the robot.

The opposite is a mesh in metres with a scale for millimetres: a part of 0.2 m becomes 0.2 mm long,
too small to see or to touch. The attribute was copied from a mesh that needs it, or the mesh was
exported again in metres. The mesh is reported if a scale of 0.01 or less makes it shorter than
1 mm.

One mesh alone with another scale than all others, such as 0.01 instead of 0.001, is reported if
that makes it much longer or shorter than they are, or if it is one of at least four fingers, whose
other meshes have one scale.

Sources:
    REP 103, units and axes: https://www.ros.org/reps/rep-0103.html
    URDF, link: https://wiki.ros.org/urdf/XML/link
"""

from collections.abc import Iterable

from urdfkit.core.grouping import by_key
from urdfkit.core.words import spaced
from urdfkit.lint.rules import Confidence, Context, Finding, Findings, Fix, Need, Severity, rule
from urdfkit.mesh.samples import box, stl
from urdfkit.robot.assets.mesh_defects import MeshDefect, rest_of_robot
from urdfkit.robot.assets.mesh_uses import MeshUse
from urdfkit.robot.fingers import odd_one, series
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

#: Least number of meshes with the usual scale, factors of a wrong decimal point, and the ratio to
#: the length of any other mesh from which one is reported.
_MANY, _DECIMAL_POINTS, _MAX_RATIO = 4, (10.0, 100.0), 5.0


@rule(
    Severity.WARNING,
    confidence=Confidence.INFERRED,
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
        yield Finding(use.at, message, fix=_fix(use), weight=length)
    for use in defects.get(MeshDefect.MICROSCOPIC, ()):
        unscaled = use.longest / max(map(abs, use.shape.scale))
        yield Finding(
            use.scale_at or use.at,
            f"{use.who} is {1000 * use.longest:.2g} mm long by its scale, and {unscaled:.3g} m "
            "without it",
            "remove the scale, or correct it",
            group_key="scale",
        )
    measured = context.measured
    for use, usual in _unlike_others(measured.files) or _unlike_fingers(measured.uses):
        yield Finding(
            use.scale_at or use.at,
            f"{use.who} is {use.longest:.3g} m long with the scale {use.shape.scale[0]:g}; the "
            f"other meshes have the scale {usual:g}",
            f'write scale="{usual:g} {usual:g} {usual:g}"',
        )


def _unlike_others(files: Iterable[MeshUse]) -> list[tuple[MeshUse, float]]:
    """The only mesh with a wrong decimal point in its scale, and the scale of all others."""
    groups = by_key((abs(use.shape.scale[0]), use) for use in files)
    if len(groups) != 2 or 0 in groups:
        return []
    (scale, wrong), (usual, others) = sorted(groups.items(), key=lambda group: len(group[1]))
    if len(wrong) > 1 or len(others) < _MANY or not _is_decimal_point(scale, usual):
        return []
    length, lengths = wrong[0].longest, [use.longest for use in others]
    is_unlike = length > _MAX_RATIO * max(lengths) or _MAX_RATIO * length < min(lengths)
    return [(wrong[0], usual)] if is_unlike else []


def _unlike_fingers(uses: Iterable[MeshUse]) -> list[tuple[MeshUse, float]]:
    """The meshes of one finger with a wrong decimal point, and the scale of the other fingers."""
    visuals = {use.link.name: use for use in uses if use.role == "visual"}
    found = []
    for names in series(visuals):
        odd = odd_one({name: abs(visuals[name].shape.scale[0]) for name in names})
        if odd and _is_decimal_point(abs(visuals[odd[0]].shape.scale[0]), odd[1]):
            found.append((visuals[odd[0]], odd[1]))
    return found


def _is_decimal_point(scale: float, usual: float) -> bool:
    small, large = sorted((scale, usual))
    return small > 0 and round(large / small, 6) in _DECIMAL_POINTS


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
