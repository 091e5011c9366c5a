"""A mesh does not enclose a volume, or is inside out.

- Its surface has holes, triangles that face opposite ways along an edge, or is a sheet with two
  sides. Inside and outside are undefined: no volume, mass or inertia can be computed from it,
  MuJoCo may reject it, and a thin object can enter through a hole. A quarter of the collision
  meshes of real robots are like that, and simulators that only test triangles live with it.
  `urdfkit mesh repair` closes small holes; `urdfkit mesh hull` makes a closed convex shape. An
  info.
- It is flat: all of it lies in one plane. Simulators that take the convex hull reject it or make
  it a sheet that fast parts tunnel through. Use a thin `<box>`. A warning; an error where MuJoCo is
  a target, which also rejects a mesh of less than 1e-15 m³, of visuals as well if it is told to
  load them (`discardvisual="false"`).
- Its closed pieces overlap by more than a twentieth of the volume, which then counts twice in the
  volume, centre of mass and inertia that Gazebo, MeshLab and `urdfkit inertia` compute. Unite them,
  as with `urdfkit mesh repair --union`, or write the inertial by hand. An info; it is also reported
  for a visual of a link without collisions.
- A closed mesh, or a piece of one, is inside out: the vertices of its triangles are clockwise as
  seen from outside. Its volume is negative: tools that compute a mass from it fail or get a
  negative one, MuJoCo rejects it, and its shading is wrong. It comes from a mirrored part or from
  the export; `urdfkit mesh repair` flips it. A warning.

Sources:
    MuJoCo, user_mesh.cc: https://github.com/google-deepmind/mujoco/blob/main/src/user/user_mesh.cc
    Mirtich, Fast and accurate computation of polyhedral mass properties: https://doi.org/10.1080/10867651.1996.10487458
    Gazebo, MeshInertiaCalculator.cc: https://github.com/gazebosim/gz-sim/blob/main/src/MeshInertiaCalculator.cc
    measured: 380 of 1 513 public collision meshes are open
"""

from urdfkit.core.words import counted
from urdfkit.lint.rules import Context, Finding, Findings, Need, Severity, rule
from urdfkit.mesh.samples import BOX, box, stl
from urdfkit.robot.assets.mesh_defects import MeshDefect
from urdfkit.robot.assets.mesh_uses import MeshUse
from urdfkit.robot.samples import mesh_xml
from urdfkit.ros.targets import TargetFacts

BAD = mesh_xml("collision", "forearm.stl")
GOOD = BAD.replace("forearm", "hand")
FILES = {
    "forearm.stl": stl(box((0, 0, 0), (0.1, 0.1, 0.3), BOX[2:])),
    "hand.stl": stl(box((0, 0, 0), (0.1, 0.1, 0.3))),
}


@rule(
    Severity.INFO,
    needs=(Need.MODEL, Need.MESHES),
    help="urdfkit mesh repair FILE, or urdfkit mesh hull FILE",
)
def check(context: Context) -> Findings:
    defects = context.measured.defects
    fatal = tuple(one.name for one in context.given_facts if one.least_volume)
    severity = Severity.ERROR if fatal else Severity.WARNING
    for use in defects.get(MeshDefect.FLAT, ()):
        x, y, z = use.edges
        message = f"{use.who} is flat: {x:.3g} x {y:.3g} x {z:.3g} m"
        yield Finding(use.at, message, "use a thin <box>", severity=severity, targets=fatal)
    for target in context.given_facts:
        if target.least_volume:
            yield from _tiny(context, target)
    yield from map(_open, defects.get(MeshDefect.OPEN, ()))
    for use in defects.get(MeshDefect.OVERLAPPING, ()):
        yield Finding(
            use.at,
            f"{use.who} has {use.measures.bodies} pieces that overlap: a mass computed from it is "
            f"{100 * use.measures.overlap:.0f} % too large",
            "unite the pieces: urdfkit mesh repair --union FILE",
            group_key="overlap",
        )
    for use in defects.get(MeshDefect.INVERTED, ()):
        found = use.measures
        what = "its triangles face inward"
        if found.bodies > 1 and found.inverted_bodies:
            what = f"{found.inverted_bodies} of its {found.bodies} pieces face inward"
        message = f"{use.who} is inside out: {what}"
        help = "urdfkit mesh repair FILE"
        yield Finding(use.at, message, help, group_key="inside out", severity=Severity.WARNING)


def _tiny(context: Context, target: TargetFacts) -> Findings:
    """The meshes that a target loads and that have less volume than it takes."""
    loads_visuals = not (target.drops_visuals and context.mujoco.drops_visuals)
    for use in context.measured.uses:
        volume = use.solid.volume if use.solid else 0.0
        # A flat collision is reported above.
        is_loaded = use.measures.hull if use.role == "collision" else loads_visuals
        if is_loaded and volume < target.least_volume:
            message = f"{use.who} has a volume of {volume:.3g} m³, which {target.title} rejects"
            help = f"correct its scale, or remove the {use.role}"
            yield Finding(use.at, message, help, severity=Severity.ERROR, targets=(target.name,))


def _open(use: MeshUse) -> Finding:
    found = use.measures
    parts = [
        counted(number, f"{kind} edge")
        for number, kind in ((found.open_edges, "open"), (found.flipped_edges, "inconsistent"))
        if number
    ]
    among = counted(found.triangles, "triangle")
    what = f"is not closed: {' and '.join(parts)} among {among}"
    if not parts:
        what = f"encloses nothing: its {among} are two sides of a sheet"
    help = "" if parts else "urdfkit mesh repair --one-sided FILE, or urdfkit mesh hull FILE"
    return Finding(use.at, f"{use.who} {what}", help, weight=found.open_edges, group_key="open")
