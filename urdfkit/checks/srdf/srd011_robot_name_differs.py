"""The robot name in the SRDF differs from the name in the URDF.

MoveIt compares the names and logs an error, "Semantic description is not specified for the same
robot as the URDF", but planning works. Use the same name in both files.

Sources:
    srdfdom, model.cpp: https://github.com/moveit/srdfdom/blob/ros2/src/model.cpp
"""

from urdfkit.lint.rules import Context, Finding, Findings, Need, Severity, rule
from urdfkit.ros.moveit.samples import named_xml
from urdfkit.text.editing.edits import fix_value

BAD = named_xml("bad", '<link name="base"/>')
GOOD = BAD.replace('"bad"', '"other"')
FILES = {"example.srdf": b'<robot name="other"/>'}
FIXED_FILES = {"example.srdf": b'<robot name="bad"/>'}


@rule(Severity.WARNING, needs=(Need.MODEL, Need.SRDF), help="give the SRDF the name of the robot")
def check(context: Context) -> Findings:
    srdf = context.required_srdf
    name = srdf.root.attributes.get("name")
    if name is not None and name.value != context.model.name:
        message = (
            f"robot name '{name.value}' in the SRDF differs from '{context.model.name}' in the URDF"
        )
        yield Finding(name, message, fix=fix_value(name, context.model.name))
