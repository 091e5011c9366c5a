"""Very many joints hang one below the other.

Programs walk the tree link by link and end at some depth: MuJoCo refuses more than 1024 moving
joints in a row, PyBullet and Pinocchio crash at a few thousand, and the error of a computed pose
grows with every joint. A rope or a chain is better made in the simulator.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.diagnostic import Severity
from urdfkit.rules import Finding, rule

if TYPE_CHECKING:
    from urdfkit.subject import Subject

#: Joints in a row. MuJoCo 4.0 refuses 1025 that move; PyBullet 3.2.7 and Pinocchio 4.1 die
#: between 3000 and 10 000.
MAX_DEPTH = 1000

BAD = """\
<robot name="rope" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="segment" params="n">
    <link name="segment_${n + 1}"/>
    <joint name="joint_${n + 1}" type="continuous">
      <parent link="segment_${n}"/>
      <child link="segment_${n + 1}"/>
    </joint>
  </xacro:macro>
  <xacro:macro name="segments" params="n left">
    <xacro:if value="${left == 1}">
      <xacro:segment n="${n}"/>
    </xacro:if>
    <xacro:if value="${left > 1}">
      <xacro:segments n="${n}" left="${left // 2}"/>
      <xacro:segments n="${n + left // 2}" left="${left - left // 2}"/>
    </xacro:if>
  </xacro:macro>

  <link name="segment_0"/>
  <xacro:segments n="0" left="1001"/>
</robot>
"""
GOOD = BAD.replace('"1001"', '"20"')


@rule("TRE009", "deep-chain", Severity.INFO, help="split the chain, or make it in the simulator")
def check(subject: Subject) -> Iterator[Finding]:
    tree = subject.tree
    if len(tree.roots) != 1:
        return  # TRE002 or TRE003 comes first
    root = tree.roots[0].name
    depth = {root: 0}
    for name in tree.below(root):
        for joint in tree.children[name]:
            assert joint.child is not None
            depth.setdefault(joint.child.value, depth[name] + 1)
    deepest = max(depth, key=lambda name: depth[name])
    if depth[deepest] > MAX_DEPTH:
        yield Finding(
            tree.model.links_by_name[deepest].at,
            f"link '{deepest}' is {depth[deepest]} joints below '{root}'; more than {MAX_DEPTH} "
            "are too many for some programs",
        )
