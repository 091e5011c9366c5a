"""The collision matrix does not match the links that joints connect.

- A pair is disabled as "Adjacent", but no joint connects the two links (warning; an info if only
  fixed joints are between them, or if one of them has no collision geometry). The pair is never
  checked for collisions. Links are also adjacent if only links without collision geometry are
  between them, or if both are next to the same link without collision geometry.
- A pair that a joint connects overlaps at the zero pose and is not disabled (warning; an info if
  the overlap is less than 1 mm, or no such pair is disabled: OpenRAVE and Pinocchio never check
  them). MoveIt finds the collision in every pose, and cannot plan. An SRDF without any matrix is
  not reported.

The matrix is older than the links, or was edited by hand; `urdfkit collisions -o` updates it.

Sources:
    SRDF: https://wiki.ros.org/srdf
    MoveIt, URDF and SRDF: https://moveit.picknik.ai/main/doc/examples/urdf_srdf/urdf_srdf_tutorial.html
    MoveIt, compute_default_collisions.cpp: https://github.com/moveit/moveit2/blob/main/moveit_setup_assistant/moveit_setup_srdf_plugins/src/compute_default_collisions.cpp
"""

from urdfkit.lint.rules import Context, Finding, Findings, Need, Severity, rule
from urdfkit.robot.adjacency import Adjacency
from urdfkit.robot.samples import collision_xml, joint_xml, link_xml
from urdfkit.ros.moveit.samples import named_xml, srdf_files
from urdfkit.ros.moveit.srdf import Srdf

_UP = '<origin xyz="0 0 0.25"/>'
BAD = named_xml(
    "bad",
    link_xml("base", collision_xml('<box size="0.2 0.2 0.2"/>')),
    link_xml("arm", collision_xml('<cylinder radius="0.04" length="0.4"/>')),
    link_xml("hand", collision_xml('<sphere radius="0.1"/>')),
    joint_xml("continuous", _UP, '<axis xyz="0 0 1"/>'),
    joint_xml("fixed", _UP, name="wrist", parent="arm", child="hand"),
)
_PAIR = '<disable_collisions link1="base" link2="arm" reason="Adjacent"/>'
GOOD = BAD.replace('"bad"', '"good"')
FILES = srdf_files(
    _PAIR, _PAIR + '<disable_collisions link1="arm" link2="hand" reason="Adjacent"/>'
)

#: In m: bodies that only touch are not reported.
_MIN_DEPTH = 1e-4
#: In m: bodies that overlap by more do so in other poses, too.
_DEEP = 1e-3


@rule(
    Severity.INFO,
    needs=(Need.MODEL, Need.SRDF, Need.COLLISIONS),
    help="update it: urdfkit collisions ROBOT -o FILE",
)
def check(context: Context) -> Findings:
    srdf = context.required_srdf
    if len(context.tree.roots) == 1:  # the cause of several trees is reported once
        yield from _not_adjacent(context, srdf)
    if not srdf.disabled:
        return
    is_for_moveit = _disables_connected_links(context, srdf)
    for pair in context.collisions.contacts_in_moveit.pairs:
        if not (pair.is_adjacent or pair.is_rigid) or srdf.disables(frozenset(pair.names)):
            continue
        if pair.contact and pair.contact.depth > _MIN_DEPTH:
            first, second = sorted(pair.names)
            is_certain = is_for_moveit and pair.contact.depth > _DEEP
            yield Finding(
                srdf.root,
                f"connected links '{first}' and '{second}' overlap by "
                f"{1000 * pair.contact.depth:.3g} mm, but their collisions are not disabled",
                severity=Severity.WARNING if is_certain else None,
                group_key="connected links",
            )


def _disables_connected_links(context: Context, srdf: Srdf) -> bool:
    known, adjacency = srdf.known("link"), Adjacency(context.tree)
    pairs = (tuple(pair) for pair in srdf.disabled if len(pair) == 2 and pair <= known)
    return any(adjacency.is_adjacent(first, second) for first, second in pairs)


def _not_adjacent(context: Context, srdf: Srdf) -> Findings:
    adjacency = Adjacency(context.tree)
    for pair in srdf.root.all("disable_collisions"):
        first, second = pair.get("link1") or "", pair.get("link2") or ""
        if (pair.get("reason") or "").lower() != "adjacent":
            continue
        known = {first, second} <= srdf.known("link")
        if known and not adjacency.is_adjacent(first, second):
            links = (context.model.links_by_name[name] for name in (first, second))
            is_harmless = adjacency.is_rigid(first, second) or not all(
                link.collisions for link in links
            )
            yield Finding(
                pair,
                f"links '{first}' and '{second}' are not adjacent: no joint connects them",
                "compute the collision matrix again, or correct the reason",
                severity=Severity.INFO if is_harmless else Severity.WARNING,
            )
