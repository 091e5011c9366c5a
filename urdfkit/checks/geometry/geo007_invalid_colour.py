"""A colour has a component outside 0 to 1, or is invisible.

Colour components in URDF range from 0 to 1. urdfdom rejects other values with an error, and the
part is drawn in the default colour (red in RViz). Values up to 255 are from a colour picker: divide
them by 255.

An alpha of 0, the fourth number, is transparent: RViz shows nothing. An info. Write 1; or, if the
link should be invisible, remove the `<visual>`, or name the material `invisible`.

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
    RViz, robot_link.cpp: https://github.com/ros2/rviz/blob/rolling/rviz_default_plugins/src/rviz_default_plugins/robot/robot_link.cpp
    urdfdom, link.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/link.cpp
"""

import re
from itertools import chain

from urdfkit.core.words import rounded, spaced
from urdfkit.lint.rules import Context, Finding, Findings, Severity, rule
from urdfkit.robot.assets.colours import Colours
from urdfkit.robot.link import Material
from urdfkit.robot.model import RobotModel
from urdfkit.robot.samples import link_xml, robot_xml, visual_xml
from urdfkit.text.editing.edits import fix_value

BAD = robot_xml(
    '<material name="orange"><color rgba="255 140 0 1"/></material>',
    link_xml("base", visual_xml('<box size="0.1 0.1 0.1"/>', '<material name="orange"/>')),
)
FIXED = GOOD = BAD.replace("255 140 0 1", "1 0.549 0 1")

#: Components up to this are inaccurate, not values up to 255.
_MAX_INACCURATE = 2.0

#: Values of an opaque alpha in another unit, next to components from 0 to 1.
_OPAQUE = (100.0, 255.0)

#: Components up to this may be percents or tenths, if alpha is 100 or 10.
_PERCENT = 100.0
_FULL = (10.0, 100.0)

#: Names of materials that are invisible on purpose.
_INTENDED = r"(?i)invisible|transparent|hidden|none|clear|glass"


@rule(Severity.ERROR, help="write red, green, blue and alpha from 0 to 1")
def check(context: Context) -> Findings:
    model = context.model
    in_visuals = (body.material for body in model.visuals)
    for material in chain(model.materials, in_visuals):
        if material and material.rgba and not all(0 <= v <= 1 for v in material.rgba.value):
            yield _finding(material, material.rgba.value)
    yield from _invisible(model)


def _invisible(model: RobotModel) -> Findings:
    reported: set[object] = set()
    for link, _, material in Colours(model).visuals():
        rgba, name = material.rgba, material.name.value if material.name else ""
        if rgba is None or material.texture or len(rgba.value) != 4 or rgba.value[3] != 0:
            continue
        if rgba.at not in reported and not re.search(_INTENDED, name):
            reported.add(rgba.at)
            called = f" '{name}'" if name else ""
            message = f"link '{link.name}': the material{called} of a visual has an alpha of 0"
            yield Finding(
                rgba, message, "write 1 as the fourth number of rgba", severity=Severity.INFO
            )


def _finding(material: Material, values: tuple[float, ...]) -> Finding:
    assert material.rgba is not None
    name = f"material '{material.name.value}'" if material.name else "the material"
    wrong = [f"{value:g}" for value in values if not 0 <= value <= 1]
    verb = "is" if len(wrong) == 1 else "are"
    better = _fixed(values)
    color = material.at.child("color")
    assert color is not None
    message = f"{name}: {', '.join(wrong)} {verb} not between 0 and 1"
    help = f'write rgba="{better}"' if better else ""
    return Finding(material.rgba, message, help, fix_value(color.attributes["rgba"], better))


def _fixed(values: tuple[float, ...]) -> str:
    """The colour in the range 0 to 1; empty if it is unknown."""
    if min(values) < 0 or max(values) > 255:
        return ""
    color, alpha = values[:3], values[3:]
    if max(color) <= _MAX_INACCURATE and max(alpha, default=0) > _MAX_INACCURATE:
        if alpha[0] not in _OPAQUE:
            return ""
        alpha = (1.0,)
    # Next to 255, a 1 is of the other unit: the colour is that of values cut off at 1.
    if max(color) <= _MAX_INACCURATE or 1.0 in color:
        return spaced(min(value, 1.0) for value in (*color, *alpha))
    if any(0 < value < 1 for value in color):
        return ""  # one of several formulas is wrong
    if max(values) <= _PERCENT and alpha and alpha[0] > 1:  # all of them in one unit
        return rounded([value / alpha[0] for value in values], 3) if alpha[0] in _FULL else ""
    parts = [value / 255 for value in color]
    parts += [value / 255 if value > 1 else value for value in alpha]
    return rounded(parts, 3)
