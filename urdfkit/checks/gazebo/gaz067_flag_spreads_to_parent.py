"""A switch that is meant for one link is thrown for a larger one.

Gazebo merges a link that hangs on a fixed joint into its parent, and `<turnGravityOff>`,
`<gravity>`, `<selfCollide>` and `<self_collide>` of the child become those of the whole. A camera
without gravity makes a robot without gravity.

Sources:
    sdformat, parser_urdf.cc: https://github.com/gazebosim/sdformat/blob/main/src/parser_urdf.cc
    measured: libsdformat 12.3 switches gravity off for the merged link
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.ros.gazebo.values import text_of
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.text.document import Element

BAD = """\
<link name="base">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<link name="camera">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<joint name="mount" type="fixed">
  <parent link="base"/>
  <child link="camera"/>
</joint>
<gazebo reference="camera">
  <turnGravityOff>true</turnGravityOff>
</gazebo>"""
GOOD = BAD.replace(">true<", ">false<")

#: The values that change nothing.
_DEFAULTS = {
    "turnGravityOff": ("false", "no", "0"),
    "gravity": ("true", "1"),
    "selfCollide": ("false", "no", "0"),
    "self_collide": ("false", "0"),
}
_DOES = {
    "turnGravityOff": "loses its weight",
    "gravity": "loses its weight",
    "selfCollide": "collides with its own robot",
    "self_collide": "collides with its own robot",
}


@rule(
    "GAZ067",
    "flag-spreads-to-parent",
    Severity.WARNING,
    needs=(Need.MODEL, Need.GAZEBO),
    help="keep the joint with <preserveFixedJoint>, or give the tag to the parent if it is meant",
)
def check(subject: Subject) -> Iterator[Finding]:
    thrown = [
        (block.get("reference") or "", tag)
        for block in subject.model.gazebo
        for tag in block.children
        if _is_thrown(tag)
    ]
    names = {(name, tag.tag) for name, tag in thrown}
    for name, tag in thrown:
        into = subject.gazebo.merged.get(name)
        if into and (into, tag.tag) not in names:
            yield Finding(
                tag,
                f"<{tag.tag}> of '{name}' also applies to '{into}', the link it is merged into, "
                f"which {_DOES[tag.tag]}",
                alike=f"{tag.tag} of {into}",
            )


def _is_thrown(tag: Element) -> bool:
    return tag.tag in _DEFAULTS and text_of(tag).lower() not in _DEFAULTS[tag.tag]
