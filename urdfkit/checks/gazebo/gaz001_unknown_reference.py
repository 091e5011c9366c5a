"""A `<gazebo reference>` names neither a link nor a joint.

Gazebo's converter compares the reference with the names of links and joints and drops the whole
block, with its sensors and friction, without a message. Correct the name; xacro prefixes are a
usual cause.

Sources:
    sdformat, parser_urdf.cc: https://github.com/gazebosim/sdformat/blob/main/src/parser_urdf.cc
    gazebosim/gz-sim#2961: https://github.com/gazebosim/gz-sim/issues/2961
"""

from __future__ import annotations

from urdfkit.core.suggest import Suggester
from urdfkit.lint.rules import Finding, Findings, Severity, Subject, rule
from urdfkit.robot.samples import robot_xml
from urdfkit.ros.gazebo.samples import gazebo_xml, solid_xml
from urdfkit.text.editing.edits import fix_value

BAD = robot_xml(solid_xml("wheel"), gazebo_xml("<mu1>0.8</mu1>", reference="whel"))
GOOD = BAD.replace("whel", "wheel")
FIXED = GOOD


@rule(Severity.ERROR, help="name a link or a joint of this robot", reports_missing=True)
def check(subject: Subject) -> Findings:
    model = subject.model
    known = {**model.links_by_name, **model.joints_by_name}
    suggester = Suggester(known)
    for block in model.gazebo:
        reference = block.attributes.get("reference")
        if reference is None or not reference.value or reference.value in known:
            continue
        if subject.is_part:  # the file that includes it has the link
            return
        if block.children:
            suggested = suggester.suggested(reference.value)
            lost = ", ".join(dict.fromkeys(f"<{child.tag}>" for child in block.children))
            yield Finding(
                reference,
                f"unknown link or joint '{reference.value}': Gazebo ignores {lost}",
                f"did you mean '{suggested}'?" if suggested else "",
                fix_value(reference, suggested),
                alike="" if suggested else "unknown",
            )
