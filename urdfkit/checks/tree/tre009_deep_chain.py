"""Very many joints hang one below the other.

Programs walk the tree link by link and end at some depth: MuJoCo refuses more than 1024 moving
joints in a row, PyBullet and Pinocchio crash at a few thousand, and the error of a computed pose
grows with every joint. A rope or a chain is better made in the simulator.

Sources:
    MuJoCo, user_model.cc: https://github.com/google-deepmind/mujoco/blob/main/src/user/user_model.cc
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

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
  <xacro:macro name="ten" params="n">
    <xacro:segment n="${n + 0}"/><xacro:segment n="${n + 1}"/>
    <xacro:segment n="${n + 2}"/><xacro:segment n="${n + 3}"/>
    <xacro:segment n="${n + 4}"/><xacro:segment n="${n + 5}"/>
    <xacro:segment n="${n + 6}"/><xacro:segment n="${n + 7}"/>
    <xacro:segment n="${n + 8}"/><xacro:segment n="${n + 9}"/>
  </xacro:macro>
  <xacro:macro name="hundred" params="n">
    <xacro:ten n="${n + 0}"/><xacro:ten n="${n + 10}"/>
    <xacro:ten n="${n + 20}"/><xacro:ten n="${n + 30}"/>
    <xacro:ten n="${n + 40}"/><xacro:ten n="${n + 50}"/>
    <xacro:ten n="${n + 60}"/><xacro:ten n="${n + 70}"/>
    <xacro:ten n="${n + 80}"/><xacro:ten n="${n + 90}"/>
  </xacro:macro>
  <xacro:macro name="thousand" params="n">
    <xacro:hundred n="${n + 0}"/><xacro:hundred n="${n + 100}"/>
    <xacro:hundred n="${n + 200}"/><xacro:hundred n="${n + 300}"/>
    <xacro:hundred n="${n + 400}"/><xacro:hundred n="${n + 500}"/>
    <xacro:hundred n="${n + 600}"/><xacro:hundred n="${n + 700}"/>
    <xacro:hundred n="${n + 800}"/><xacro:hundred n="${n + 900}"/>
  </xacro:macro>

  <link name="segment_0"/>
  <xacro:thousand n="0"/>
  <xacro:segment n="1000"/>
</robot>
"""
GOOD = BAD.replace('<xacro:thousand n="0"/>\n  <xacro:segment n="1000"/>', '<xacro:hundred n="0"/>')


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
