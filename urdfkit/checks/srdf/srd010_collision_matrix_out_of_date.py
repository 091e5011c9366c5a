"""The collision matrix does not fit the links that joints connect.

- A pair is disabled as "Adjacent" although no joint connects the two links (warning). The pair is
  never checked for collisions. Links with only links without collision geometry between them count
  as adjacent, as do all links around one without collision geometry.
- A pair that a joint connects overlaps at the zero pose and is not disabled (info). MoveIt finds
  the collision in every pose, and plans nothing. An SRDF without any matrix is not reported.

The matrix is older than the links, or was edited by hand; `urdfkit collisions --srdf` updates it.

Sources:
    SRDF: https://wiki.ros.org/srdf
    MoveIt, URDF and SRDF: https://moveit.picknik.ai/main/doc/examples/urdf_srdf/urdf_srdf_tutorial.html
    MoveIt, compute_default_collisions.cpp: https://github.com/moveit/moveit2/blob/main/moveit_setup_assistant/moveit_setup_srdf_plugins/src/compute_default_collisions.cpp
"""

from __future__ import annotations

from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, Need, rule
from urdfkit.robot.adjacency import Adjacency
from urdfkit.ros.moveit.srdf import Srdf
from urdfkit.text.diagnostic import Severity

BAD = """\
<robot name="bad">
  <link name="base">
    <collision><geometry><box size="0.2 0.2 0.2"/></geometry></collision>
  </link>
  <link name="arm">
    <collision><geometry><cylinder radius="0.04" length="0.4"/></geometry></collision>
  </link>
  <link name="hand">
    <collision><geometry><sphere radius="0.1"/></geometry></collision>
  </link>
  <joint name="shoulder" type="revolute">
    <parent link="base"/>
    <child link="arm"/>
    <origin xyz="0 0 0.25"/>
    <axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="10" velocity="1"/>
  </joint>
  <joint name="wrist" type="fixed">
    <parent link="arm"/>
    <child link="hand"/>
    <origin xyz="0 0 0.25"/>
  </joint>
</robot>
"""
GOOD = BAD.replace('"bad"', '"good"')
FILES = {
    "bad.srdf": b"""<robot name="bad">
  <disable_collisions link1="base" link2="arm" reason="Adjacent"/>
</robot>
""",
    "good.srdf": b"""<robot name="good">
  <disable_collisions link1="base" link2="arm" reason="Adjacent"/>
  <disable_collisions link1="arm" link2="hand" reason="Adjacent"/>
</robot>
""",
}

#: In m: bodies that touch do not count.
_DEEP = 1e-4


@rule(
    Severity.INFO,
    needs=(Need.MODEL, Need.SRDF, Need.COLLISIONS),
    help="update it: urdfkit collisions ROBOT --srdf FILE",
)
def check(subject: Subject) -> Findings:
    srdf = subject.srdf
    if srdf is None:
        return
    yield from _not_adjacent(subject, srdf)
    if not srdf.disabled:
        return
    for pair in subject.collisions.contacts_in_moveit.pairs:
        if not (pair.is_adjacent or pair.is_rigid) or srdf.disables(frozenset(pair.names)):
            continue
        if pair.contact and pair.contact.depth > _DEEP:
            first, second = sorted(pair.names)
            yield Finding(
                srdf.root,
                f"connected links '{first}' and '{second}' overlap by "
                f"{1000 * pair.contact.depth:.3g} mm, but their collisions are not disabled",
            )


def _not_adjacent(subject: Subject, srdf: Srdf) -> Findings:
    adjacency = Adjacency(subject.tree)
    for pair in srdf.root.all("disable_collisions"):
        first, second = pair.get("link1") or "", pair.get("link2") or ""
        if (pair.get("reason") or "").lower() != "adjacent":
            continue
        known = {first, second} <= srdf.known("link")
        if known and not adjacency.is_adjacent(first, second):
            yield Finding(
                pair,
                f"links '{first}' and '{second}' are not adjacent: no joint connects them",
                "compute the collision matrix again, or correct the reason",
                severity=Severity.WARNING,
            )
