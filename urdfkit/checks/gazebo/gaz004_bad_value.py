"""The value of a tag in a `<gazebo>` block is not what Gazebo can read.

Where Gazebo's converter wants a number, other text ends the whole conversion with an exception, and
a decimal comma reads as the digits before it, as does anything else behind a number. Where it wants
a boolean, it looks for `true`, `yes` and `1` (for `turnGravityOff`: `false`, `no` and `0`) and
takes everything else for the opposite.

Sources:
    sdformat, parser_urdf.cc: https://github.com/gazebosim/sdformat/blob/main/src/parser_urdf.cc
"""

from __future__ import annotations

from math import isnan

from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, rule
from urdfkit.robot.model import RobotModel, number
from urdfkit.ros.catalog.extensions import Extension, extensions
from urdfkit.ros.gazebo.values import leading, text_of, value
from urdfkit.text.diagnostic import Fix, Severity
from urdfkit.text.document import Element
from urdfkit.text.editing.edits import replace_text

BAD = """\
<link name="wheel">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<gazebo reference="wheel">
  <mu1>0,8</mu1>
</gazebo>"""
GOOD = BAD.replace("0,8", "0.8")
FIXED = GOOD

_WORDS = ("true", "yes", "1", "false", "no", "0")
#: Friction and stiffness.
_NOT_NEGATIVE = ("mu1", "mu2", "kp", "kd", "minDepth", "maxVel", "maxContacts")
#: Booleans of SDF that the converter copies as they stand.
_COPIED = ("gravity", "self_collide", "kinematic", "enable_wind", "must_be_base_link")


@rule(Severity.ERROR)
def check(subject: Subject) -> Findings:
    handled = extensions()
    for block in subject.model.gazebo:
        for child in block.children:
            text = text_of(child)
            if extension := handled.get(child.tag):
                if extension.type != "bool" or _is_read(subject.model, block, extension):
                    yield from _handled(child, extension, text)
            elif child.tag in _COPIED and text.lower() not in ("true", "false", "1", "0"):
                message = f"<{child.tag}> is {_shown(text)}: SDF wants true, false, 1 or 0"
                yield Finding(child, f"{message}, and rejects the model", "write true or false")


def _is_read(model: RobotModel, block: Element, extension: Extension) -> bool:
    """True unless a tag for links is in the block of a joint, or the other way round (GAZ005)."""
    name = block.get("reference")
    is_link, is_joint = name in model.links_by_name, name in model.joints_by_name
    return is_link == is_joint or extension.on != ("joint" if is_link else "link")


def _handled(child: Element, extension: Extension, text: str) -> Findings:
    name = f"<{child.tag}> is {_shown(text)}"
    if extension.type in ("float", "int"):
        yield from _wrong_number(child, text, name)
    elif extension.type == "vector3":
        parts = [number(part) for part in text.split()]
        if len(parts) != 3 or None in parts:
            yield Finding(child, f"{name}, and must be 3 numbers", "write three numbers")
    elif extension.type == "bool" and text.lower() not in _WORDS:
        read = "false" if extension.words == "yes" else "true"
        message = f"{name}, which Gazebo takes for {read}"
        yield Finding(child, message, "write true or false")


def _wrong_number(child: Element, text: str, name: str) -> Findings:
    read, rest = leading(text)
    if not read:
        message = f"{name}, which is not a number: Gazebo's converter ends with an exception"
        yield Finding(child, message, "write a number")
    elif rest.startswith(","):
        message = f"{name}: Gazebo reads {read}, for a comma ends the number"
        right = text.replace(",", ".")
        edits = replace_text(child, right) if child.text.strip() == text else None
        fix = Fix.of(f"write {right}", edits)
        yield Finding(child, message, f"write {right}", fix)
    elif rest:
        message = f"{name}: Gazebo reads {read} and ignores '{rest}'"
        yield Finding(child, message, "write the number alone")
    elif isnan(value(read)):
        yield Finding(child, f"{name}: the simulation spreads it to all links", "write a number")
    elif child.tag in _NOT_NEGATIVE and value(read) < 0:
        message = f"{name}: a negative value makes contacts pull or explode"
        yield Finding(child, message, "write 0 or more")


def _shown(text: str) -> str:
    return f"'{text}'" if text else "empty"
