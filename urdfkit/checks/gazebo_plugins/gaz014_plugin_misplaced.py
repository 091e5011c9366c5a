"""A plugin stands where Gazebo does not run it.

A model plugin belongs in a `<gazebo>` block without a reference, a sensor plugin in a `<sensor>` in
the block of a link. A plugin that stands directly in the block of a link or joint is copied into
that link and never loaded; one of the wrong kind ends with an error about its type.

Sources:
    Gazebo Classic, plugins: https://classic.gazebosim.org/tutorials?tut=ros_gzplugins
    sdformat, parser_urdf.cc: https://github.com/gazebosim/sdformat/blob/main/src/parser_urdf.cc
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.ros.gazebo.plugins import PluginUse

BAD = """\
<link name="base">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<gazebo reference="base">
  <plugin name="drive" filename="libgazebo_ros_planar_move.so"/>
</gazebo>"""
GOOD = BAD.replace(' reference="base"', "")

_WHERE = {
    "model": "in a <gazebo> block without a reference",
    "sensor": "in a <sensor> in the block of a link",
    "visual": "in a <visual> in the block of a link",
    "world": "in the world, not in a robot",
    "system": "on the command line of the server, not in a robot",
    "actor": "in an actor, not in a robot",
}


@rule("GAZ014", "plugin-misplaced", Severity.ERROR, needs=(Need.MODEL, Need.GAZEBO))
def check(subject: Subject) -> Iterator[Finding]:
    known = {*subject.model.links_by_name, *subject.model.joints_by_name}
    for use in subject.plugins:
        reference = use.block.get("reference")
        if use.place == "link" and reference not in known:
            continue  # GAZ001 tells that the whole block is lost
        kinds = use.plugin.kinds if use.plugin else ()
        where = " or ".join(_WHERE[kind] for kind in kinds)
        if use.place == "link":
            message = f"{use.title} stands in the block of '{reference}', where Gazebo never runs"
            yield Finding(use.at, f"{message} it", f"put it {where or _WHERE['model']}")
        elif _is_wrong(use, kinds):
            message = f"{use.title} stands {_WHERE[use.place]}, and is for a {' or '.join(kinds)}"
            yield Finding(use.at, message, f"put it {where}", alike=f"{use.place} {where}")


def _is_wrong(use: PluginUse, kinds: tuple[str, ...]) -> bool:
    """True for a kind that Gazebo refuses there.

    gz-sim runs a world's system in a model or sensor, too, which GAZ033 tells; others that stand
    in a sensor find no model.
    """
    if not kinds or use.place in kinds or use.place not in ("model", "sensor", "visual"):
        return False
    assert use.plugin is not None
    at_home = use.place == "model" or (use.place == "sensor" and "world" in kinds)
    return not (use.plugin.generation == "gz" and at_home)
