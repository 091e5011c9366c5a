"""A mesh has so many triangles that it slows down simulation, planning or rendering.

- More than 20 000 triangles in a collision: simulators and planners test it thousands of times a
  second. Simulation falls behind real time, and MoveIt plans in seconds instead of milliseconds. A
  warning; an error above 200 000 in an STL file, which MuJoCo rejects, if it is a target.
- More than 5 000 triangles in a visual mesh that is used for collision as well: screws and fillets
  that make a part look good make collision checks slow and contacts noisy. An info.
- More than 100 000 triangles in a visual: the robot loads slowly, and RViz, Gazebo and simulated
  cameras render it slowly. An info.

For collisions, a box, a cylinder or a convex hull is faster and gives better contacts: `urdfkit
mesh collision` suggests the best. `urdfkit mesh simplify` keeps the shape with fewer triangles.

Sources:
    MuJoCo, stl_decoder.cc: https://github.com/google-deepmind/mujoco/blob/main/plugin/stl_decoder/stl_decoder.cc
    RobotLocomotion/drake#13125: https://github.com/RobotLocomotion/drake/issues/13125
    gazebosim/sdformat#68: https://github.com/gazebosim/sdformat/issues/68
    measured: 49 of 1 513 public collision meshes have more than 20 000 triangles
    measured: 131 of 676 public models use a visual mesh for collision
"""

from collections.abc import Iterable

from urdfkit.lint.rules import Context, Finding, Findings, Need, Severity, rule
from urdfkit.mesh.io.facts import BINARY_STL
from urdfkit.mesh.samples import box, stl
from urdfkit.robot.assets.mesh_uses import MeshUse
from urdfkit.robot.samples import mesh_xml
from urdfkit.ros import targets

BAD = mesh_xml("collision", "forearm.stl")
GOOD = BAD.replace("forearm", "hand")
FILES = {
    "forearm.stl": stl(box((0, 0, 0), (0.1, 0.1, 0.3)), copies=1700),
    "hand.stl": stl(box((0, 0, 0), (0.1, 0.1, 0.3))),
}


@rule(
    Severity.WARNING,
    needs=(Need.MODEL, Need.MESHES),
    help="make a lighter one: urdfkit mesh collision FILE, or urdfkit mesh simplify FILE",
    options={"triangles": 20_000, "shared-triangles": 5_000, "visual-triangles": 100_000},
)
def check(context: Context) -> Findings:
    bound = check.option(context, "triangles")
    yield from _slow_collisions(context, bound)
    least = check.option(context, "shared-triangles")
    for use in _visual_and_collision(context.measured.uses):
        number = use.measures.triangles
        if least < number <= bound:
            yield Finding(
                use.at,
                f"{use.who} is the visual mesh ({number:,} triangles, more than {least:,}); "
                "consider a simpler one",
                "urdfkit mesh collision suggests a simple shape",
                weight=number,
                severity=Severity.INFO,
            )
    most = check.option(context, "visual-triangles")
    for use in context.measured.files:
        number = use.measures.triangles
        if use.role == "visual" and number > most:
            yield Finding(
                use.at,
                f"{use.who} has {number:,} triangles; more than {most:,} make rendering slow",
                "urdfkit mesh simplify FILE",
                weight=number,
                severity=Severity.INFO,
            )


def _slow_collisions(context: Context, bound: float) -> Findings:
    collisions = [use for use in context.measured.files if use.role == "collision"]
    dense = [use for use in collisions if use.measures.triangles > bound]
    for use in sorted(dense, key=lambda use: -use.measures.triangles):
        number = use.measures.triangles
        rejecting = []
        if context.files.facts(use.path).format == BINARY_STL:
            facts = map(targets.facts_of, context.given_targets or targets.TARGETS)
            rejecting = [target for target in facts if 0 < target.most_triangles < number]
        bounds = [
            f"{target.title} rejects more than {target.most_triangles:,}" for target in rejecting
        ]
        fatal = tuple(target.name for target in rejecting if target.name in context.given_targets)
        yield Finding(
            use.at,
            f"{use.who} has {number:,} triangles; more than {bound:,} make collision "
            f"{', and '.join(['checking slow', *bounds])}",
            weight=number,
            severity=Severity.ERROR if fatal else None,
            targets=fatal,
        )


def _visual_and_collision(uses: list[MeshUse]) -> Iterable[MeshUse]:
    """The first collision with each file that is also a visual of the same link."""
    visuals = {(use.link.name, use.path) for use in uses if use.role == "visual"}
    first: dict[str, MeshUse] = {}
    for use in uses:
        if use.role == "collision" and (use.link.name, use.path) in visuals:
            first.setdefault(use.path, use)
    return first.values()
