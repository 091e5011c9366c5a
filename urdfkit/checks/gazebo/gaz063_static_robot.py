"""The robot is static in Gazebo, although it has movable joints and plugins.

`<static>true</static>` fixes a model to the world: no joint moves, no wheel drives, and controllers
load without an error. It is often left over from a first test of the model. Gazebo ignores the tag
in a block with a reference, as in `<gazebo reference="world">`.

Sources:
    SDF, model: http://sdformat.org/spec?ver=1.9&elem=model
    sdformat, parser_urdf.cc: https://github.com/gazebosim/sdformat/blob/main/src/parser_urdf.cc
"""

from urdfkit.lint.rules import Context, Finding, Findings, Need, Severity, rule
from urdfkit.robot.joint import DEGREES_OF_FREEDOM
from urdfkit.ros.gazebo.samples import ARM, gazebo_xml, plugin_xml
from urdfkit.ros.gazebo.values import is_true

_PLUGIN = plugin_xml("control", "libgazebo_ros_control.so")
BAD = ARM + gazebo_xml("<static>true</static>", _PLUGIN)
GOOD = BAD.replace("true", "false")


@rule(Severity.WARNING, needs=(Need.MODEL, Need.GAZEBO), help="remove the tag")
def check(context: Context) -> Findings:
    if not context.plugins:
        return  # a model that is only displayed
    moving = [joint.name for joint in context.model.joints if joint.kind in DEGREES_OF_FREEDOM]
    who = f"joint '{moving[0]}'" if len(moving) == 1 else f"{len(moving)} joints"
    for block in context.model.gazebo:
        if block.get("reference"):
            continue
        for element in block.all("static"):
            if moving and is_true(element):
                yield Finding(element, f"the model is static in Gazebo: {who} cannot move")
