"""A mesh does not enclose a volume, or is inside out.

- The surface has holes, or triangles that face opposite ways along an edge, or it is a sheet with
  two sides. Inside and outside are undefined: no volume, mass or inertia can be computed from the
  mesh, MuJoCo may reject it, and a thin object can enter through a hole. A quarter of the collision
  meshes of real robots have this defect, and simulators that only test triangles tolerate it.
  `urdfkit mesh repair` closes small holes; `urdfkit mesh hull` creates a closed convex shape. An
  info.
- The mesh is flat: all vertices are in one plane. Simulators that use the convex hull reject it or
  make it a sheet that fast parts tunnel through. Use a thin `<box>`. A warning; an error if MuJoCo
  is a target, which also rejects a mesh of less than 1e-15 m³, and checks visuals as well if it
  loads them (`discardvisual="false"`).
- Closed pieces of the mesh overlap by more than a twentieth of the volume, which then counts twice
  in the volume, centre of mass and inertia that Gazebo, MeshLab and `urdfkit inertia` compute.
  Unite them, for example with `urdfkit mesh repair --union`, or write the inertial by hand. An
  info; it is also reported for a visual of a link without collisions.
- A closed mesh, or a piece of one, is inside out: the vertices of its triangles are clockwise as
  seen from outside. Its volume is negative: tools that compute a mass from it fail or get a
  negative mass, MuJoCo rejects it, and its shading is wrong. The cause is a mirrored part or the
  export; `urdfkit mesh repair` flips it. A warning.

Sources:
    MuJoCo, user_mesh.cc: https://github.com/google-deepmind/mujoco/blob/main/src/user/user_mesh.cc
    Mirtich, Fast and accurate computation of polyhedral mass properties: https://doi.org/10.1080/10867651.1996.10487458
    Gazebo, MeshInertiaCalculator.cc: https://github.com/gazebosim/gz-sim/blob/main/src/MeshInertiaCalculator.cc
    measured: 380 of 1 513 public collision meshes are open
"""

from collections.abc import Iterable

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


#: Shortest edge of the bounding box of a flat mesh that is oblique, over the longest.
OBLIQUE = 1e-3


@rule(
    Severity.INFO,
    needs=(Need.MODEL, Need.MESHES),
    help="urdfkit mesh repair FILE, or urdfkit mesh hull FILE",
)
def check(context: Context) -> Findings:
    defects = context.measured.defects
    yield from _flat(context, defects.get(MeshDefect.FLAT, ()))
    for target in context.given_facts:
        if target.least_volume:
            yield from _tiny(context, target)
    yield from map(_open, defects.get(MeshDefect.OPEN, ()))
    yield from map(_overlapping, defects.get(MeshDefect.OVERLAPPING, ()))
    yield from map(_inverted, defects.get(MeshDefect.INVERTED, ()))


def _flat(context: Context, uses: Iterable[MeshUse]) -> Findings:
    fatal = tuple(target.name for target in context.given_facts if target.least_volume)
    severity = Severity.ERROR if fatal else Severity.WARNING
    for use in uses:
        x, y, z = use.edges
        size = f"{x:.3g} x {y:.3g} x {z:.3g} m"
        if min(use.edges) > OBLIQUE * use.longest:
            size = f"all its vertices are in one plane, oblique in its bounding box of {size}"
        yield Finding(
            use.at,
            f"{use.who} is flat: {size}",
            "use a thin <box>",
            severity=severity,
            targets=fatal,
            group_key="flat",
        )


def _overlapping(use: MeshUse) -> Finding:
    return Finding(
        use.at,
        f"{use.who} has {use.measures.bodies} pieces that overlap: a mass computed from it is "
        f"{100 * use.measures.overlap:.0f} % too large",
        "unite the pieces: urdfkit mesh repair --union FILE",
        group_key="overlap",
    )


def _inverted(use: MeshUse) -> Finding:
    measures = use.measures
    reason = "its triangles face inward"
    if measures.bodies > 1 and measures.inverted_bodies:
        reason = f"{measures.inverted_bodies} of its {measures.bodies} pieces face inward"
    message = f"{use.who} is inside out: {reason}"
    help = "urdfkit mesh repair FILE"
    return Finding(use.at, message, help, group_key="inside out", severity=Severity.WARNING)


def _tiny(context: Context, target: TargetFacts) -> Findings:
    """Meshes that a target loads, with less volume than it accepts."""
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
    measures = use.measures
    parts = [
        counted(number, f"{kind} edge")
        for number, kind in (
            (measures.open_edges, "open"),
            (measures.flipped_edges, "inconsistent"),
        )
        if number
    ]
    among = counted(measures.triangles, "triangle")
    reason = f"is not closed: {' and '.join(parts)} among {among}"
    if not parts:
        reason = f"encloses nothing: its {among} are two sides of a sheet"
    help = "" if parts else "urdfkit mesh repair --one-sided FILE, or urdfkit mesh hull FILE"
    return Finding(
        use.at, f"{use.who} {reason}", help, weight=measures.open_edges, group_key="open"
    )
