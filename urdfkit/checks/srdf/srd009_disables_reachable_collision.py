"""The collision matrix disables a pair as "Never" that can collide.

MoveIt does not check the pair, and may drive one link into the other. A pose in which they overlap
was found among some thousand samples within the joint limits, with the collision geometry as MoveIt
reads it. In that pose no pair that MoveIt checks overlaps, so MoveIt would not avoid it. The matrix
is of an older robot, or was computed from too few samples. `urdfkit collisions -o` computes it
again and keeps the rest of the file. Pairs with another reason, such as "User", are intended and
not reported; nor are adjacent links, which MoveIt always disables, and links whose mesh has another
unit, which MoveIt does not read (MSH013).

Sources:
    MoveIt, compute_default_collisions.cpp: https://github.com/moveit/moveit2/blob/main/moveit_setup_assistant/moveit_setup_srdf_plugins/src/compute_default_collisions.cpp
"""

from collections.abc import Iterator

from urdfkit.lint.rules import Context, Finding, Findings, Need, Severity, rule
from urdfkit.mesh.io.facts import has_other_unit
from urdfkit.robot.adjacency import Adjacency
from urdfkit.robot.samples import collision_xml, joint_xml, link_xml
from urdfkit.ros.moveit.samples import named_xml, srdf_files
from urdfkit.ros.moveit.srdf import pair_of
from urdfkit.text.document import Element

_UP, _FAR = '<origin xyz="0 0 0.5"/>', '<origin xyz="0 0 0.7"/>'
_LIMIT = '<limit lower="-1" upper="1" effort="10" velocity="1"/>'
_WIDE = _LIMIT.replace("1", "3", 2)
BAD = named_xml(
    "bad",
    link_xml("base", collision_xml('<sphere radius="0.2"/>')),
    link_xml("arm", collision_xml('<cylinder radius="0.04" length="0.4"/>', _UP)),
    link_xml("hand", collision_xml('<sphere radius="0.1"/>', _UP)),
    joint_xml("revolute", '<axis xyz="0 1 0"/>', _LIMIT),
    joint_xml("revolute", _FAR, '<axis xyz="0 1 0"/>', _WIDE, name="e", parent="arm", child="hand"),
)
GOOD = BAD.replace('"bad"', '"good"')
FILES = srdf_files(
    '<disable_collisions link1="base" link2="hand" reason="Never"/>',
    '<disable_collisions link1="base" link2="hand" reason="User"/>',
)

#: In m: a smaller overlap may be due to rounding.
_MIN_DEPTH = 1e-3
_SAMPLES = 2000
#: Most pairs times samples: all samples up to 200 pairs. A humanoid with hands has 2000 pairs,
#: which would take a minute; fewer samples are enough to find mistakes.
_MAX_QUERIES = 400_000


@rule(
    Severity.WARNING,
    needs=(Need.MODEL, Need.SRDF, Need.COLLISIONS),
    help="compute the matrix again: urdfkit collisions ROBOT -o FILE",
)
def check(context: Context) -> Findings:
    never = list(_never_colliding(context))
    if not never:
        return
    configurations = context.collisions.sampled_in_moveit
    never = [(at, pair) for at, pair in never if all(map(configurations.has_bodies, pair))]
    samples = min(_SAMPLES, _MAX_QUERIES // max(len(never), 1))
    disables, pairs = context.required_srdf.disables, [pair for _, pair in never]
    collisions = configurations.colliding(pairs, samples, lambda pair: not disables(pair))
    for (element, (first, second)), collision in zip(never, collisions, strict=True):
        if collision and collision.depth > _MIN_DEPTH:
            pose = ", ".join(f"{name} {at:.3g}" for name, at in collision.pose.items())
            message = (
                f"'{first}' and '{second}' overlap by {1000 * collision.depth:.1f} mm at {pose}"
            )
            yield Finding(element, message, weight=collision.depth, group_key="never")


def _never_colliding(context: Context) -> Iterator[tuple[Element, tuple[str, str]]]:
    """The pairs that are disabled with the reason Never alone.

    Without adjacent links, and links with a mesh whose unit MoveIt does not read.
    """
    adjacency = Adjacency(context.tree)
    disabled = context.required_srdf.root.all("disable_collisions")
    intended = {pair_of(element) for element in disabled if not _is_never(element)}
    scaled = {
        mesh.link.name
        for mesh in context.files.meshes
        if mesh.role == "collision" and mesh.facts and has_other_unit(mesh.facts)
    }
    known = context.model.links_by_name.keys() - scaled
    for element in disabled:
        first, second = element.get("link1") or "", element.get("link2") or ""
        is_known = first in known and second in known and first != second
        is_never = is_known and pair_of(element) not in intended
        if is_never and not adjacency.is_adjacent(first, second):
            yield element, (first, second)


def _is_never(element: Element) -> bool:
    return (element.get("reason") or "").lower() == "never"
