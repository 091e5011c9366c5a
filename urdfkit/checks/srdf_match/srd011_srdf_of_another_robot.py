"""The SRDF is for another robot, or for another variant of it.

- The robot name in the SRDF differs from the name in the URDF. MoveIt compares the names and logs
  an error, "Semantic description is not specified for the same robot as the URDF", but planning
  works. Use the same name in both files. A warning.
- Many of its links and joints are in another robot of the package, or differ by a prefix: the SRDF
  is for the complete robot and this is only its arm, or the robot was expanded with
  `prefix:=left_`. MoveIt does not load the two together. The other rules for the SRDF do not run in
  this case. An info.

Sources:
    srdfdom, model.cpp: https://github.com/moveit/srdfdom/blob/ros2/src/model.cpp
    MoveIt, robot_model.cpp: https://github.com/moveit/moveit2/blob/main/moveit_core/robot_model/src/robot_model.cpp
"""

from urdfkit.lint.rules import Context, Finding, Findings, Need, Severity, rule
from urdfkit.ros.moveit.samples import named_xml
from urdfkit.text.editing.edits import fix_value

BAD = named_xml("bad", '<link name="base"/>')
GOOD = BAD.replace('"bad"', '"other"')
FILES = {"example.srdf": b'<robot name="other"/>'}
FIXED_FILES = {"example.srdf": b'<robot name="bad"/>'}


@rule(Severity.WARNING, needs=(Need.MODEL, Need.SRDF), reports_missing=True)
def check(context: Context) -> Findings:
    srdf = context.required_srdf
    name = srdf.root.attributes.get("name")
    if context.other_variant:
        help = "check the variant that the SRDF is for, or generate an SRDF for this variant"
        yield Finding(srdf.root, context.other_variant, help, severity=Severity.INFO)
    elif name is not None and name.value != context.model.name and not srdf.is_shared:
        message = (
            f"robot name '{name.value}' in the SRDF differs from '{context.model.name}' in the URDF"
        )
        help, fix = "give the SRDF the name of the robot", fix_value(name, context.model.name)
        if any(mark in context.model.name for mark in "/\\"):  # onshape-to-robot on Windows
            of_robot = context.document.root.attributes.get("name")
            help = f"name the robot '{name.value}' in the URDF, where the name is a path"
            fix = fix_value(of_robot, name.value) if of_robot else None
        yield Finding(name, message, help, fix)
