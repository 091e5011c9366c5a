"""Two mesh files of a robot have the same content.

A later correction of one copy is easily forgotten in the other, and programs load both. Refer to
one file from both places; a `<mesh>` can be mirrored with its scale and moved with its `<origin>`.
"""

from urdfkit.core.words import more_like_this
from urdfkit.lint.rules import Context, Finding, Findings, Need, Related, Severity, rule
from urdfkit.mesh.samples import box, stl
from urdfkit.robot.samples import joint_xml, link_xml, robot_xml, visual_xml

BAD = robot_xml(
    link_xml("left", visual_xml('<mesh filename="left.stl"/>')),
    link_xml("right", visual_xml('<mesh filename="right.stl"/>')),
    joint_xml("fixed", name="axle", parent="left", child="right"),
)
GOOD = BAD.replace("right.stl", "left.stl")
FILES = dict.fromkeys(("left.stl", "right.stl"), stl(box((0, 0, 0), (0.1, 0.1, 0.3))))


@rule(Severity.INFO, needs=(Need.MODEL, Need.FILES), help="refer to one of them from both places")
def check(context: Context) -> Findings:
    copies = context.files.copies
    if not copies:
        return
    (copy, first), *others = copies
    message = f"{copy.who} has the same content as '{first.at.value}'{more_like_this(len(others))}"
    yield Finding(copy.at, message, related=(Related(first.at.span, "the other file"),))
