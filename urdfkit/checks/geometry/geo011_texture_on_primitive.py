"""A box, a cylinder or a sphere has a texture.

RViz maps the image to the shape in its own way. Gazebo ignores `<texture>` and draws the plain
colour, or grey. For an image that all programs show in the same place, use a mesh with texture
coordinates (COLLADA or glTF).

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
    RViz, robot_link.cpp: https://github.com/ros2/rviz/blob/rolling/rviz_default_plugins/src/rviz_default_plugins/robot/robot_link.cpp
    sdformat, parser_urdf.cc: https://github.com/gazebosim/sdformat/blob/main/src/parser_urdf.cc
"""

from urdfkit.lint.rules import Context, Finding, Findings, Severity, rule
from urdfkit.robot.assets.colours import Colours
from urdfkit.robot.samples import link_xml, visual_xml
from urdfkit.robot.shapes import SIZES
from urdfkit.text.document import Attribute, Element

_TEXTURE = '<texture filename="package://sign_description/textures/logo.png"/>'
_MATERIAL = f'<material name="logo">{_TEXTURE}</material>'
BAD = link_xml("sign", visual_xml('<box size="0.3 0.01 0.2"/>', _MATERIAL))
GOOD = BAD.replace(_TEXTURE, '<color rgba="0 0 1 1"/>')


@rule(
    Severity.INFO,
    help="use a mesh with texture coordinates, and give the material a <color> for the others",
)
def check(context: Context) -> Findings:
    reported: set[Element | Attribute] = set()
    for link, body, material in Colours(context.model).visuals():
        texture, kind = material.texture, body.shape.kind if body.shape else ""
        if texture and kind in SIZES and texture.at not in reported:
            reported.add(texture.at)
            message = f"link '{link.name}' has a texture on a {kind}, which only RViz shows"
            yield Finding(texture, message)
