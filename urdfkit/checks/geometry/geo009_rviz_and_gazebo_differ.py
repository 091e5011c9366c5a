"""A link looks different in RViz and in Gazebo.

- Its colours differ. Gazebo uses the `<material>` in `<gazebo reference="...">`, RViz that in the
  `<visual>`. Give both the same colour. Gazebo Classic needs its own material, as it does not read
  the URDF's colours; Gazebo reads them from Fortress on, and the `<material>` in `<gazebo>` can be
  removed.
- A box, a cylinder or a sphere has a texture. RViz maps the image to the shape in its own way.
  Gazebo ignores `<texture>` and draws the plain colour, or grey. For an image that all programs
  show in the same place, use a mesh with texture coordinates (COLLADA or glTF).

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
    RViz, robot_link.cpp: https://github.com/ros2/rviz/blob/rolling/rviz_default_plugins/src/rviz_default_plugins/robot/robot_link.cpp
    sdformat, parser_urdf.cc: https://github.com/gazebosim/sdformat/blob/main/src/parser_urdf.cc
    Gazebo Classic, URDF: https://classic.gazebosim.org/tutorials?tut=ros_urdf
    gz-sim, migration of materials: https://github.com/gazebosim/gz-sim/blob/main/tutorials/migration_sdf.md
"""

from urdfkit.core.grouping import by_key
from urdfkit.core.words import spaced
from urdfkit.lint.rules import Context, Finding, Findings, Related, Severity, rule
from urdfkit.robot.assets.colours import Colours
from urdfkit.robot.link import Body, Link, Material
from urdfkit.robot.samples import link_xml, robot_xml, visual_xml
from urdfkit.robot.shapes import SIZES
from urdfkit.ros.catalog.materials import materials
from urdfkit.ros.targets import GAZEBO
from urdfkit.text.document import Attribute, Element

_BLACK = '<material name="black"><color rgba="0 0 0 1"/></material>'
BAD = robot_xml(
    link_xml("wheel", visual_xml('<cylinder radius="0.06" length="0.05"/>', _BLACK)),
    '<gazebo reference="wheel">\n  <material>Gazebo/Red</material>\n</gazebo>',
)
GOOD = BAD.replace("Gazebo/Red", "Gazebo/Black")

#: Difference in red, green or blue, above which two colours are clearly different.
_TOLERANCE = 0.4

_TEXTURE_HELP = (
    "use a mesh with texture coordinates, and give the material a <color> for the others"
)


@rule(Severity.INFO, help="give both the same colour")
def check(context: Context) -> Findings:
    shown = list(Colours(context.model).visuals())
    yield from _textures(shown)
    names = [name for name in context.targets.names if name in GAZEBO]
    if names == ["gz-fortress"]:
        return  # which has no material scripts
    in_gz = bool(names) and not any(name.startswith("classic") for name in names)
    plain = by_key(
        (link.name, material)
        for link, _, material in shown
        if material.rgba and not material.texture
    )
    # Of several materials for Gazebo the last counts.
    of_gazebo = {
        block.get("reference") or "": child
        for block in context.model.gazebo
        for child in block.all("material")
    }
    for name, element in of_gazebo.items():
        rgb, others = _color(element, in_gz=in_gz), plain.get(name, [])
        if rgb and others and not any(_is_similar(element, rgb, other) for other in others):
            yield _finding(name, element, rgb, others[0])


def _textures(shown: list[tuple[Link, Body, Material]]) -> Findings:
    reported: set[Element | Attribute] = set()
    for link, body, material in shown:
        texture, kind = material.texture, body.shape.kind if body.shape else ""
        if texture and kind in SIZES and texture.at not in reported:
            reported.add(texture.at)
            message = f"link '{link.name}' has a texture on a {kind}, which only RViz shows"
            yield Finding(texture, message, _TEXTURE_HELP)


def _named(element: Element) -> str:
    return element.get("value") or element.text.strip()


def _color(element: Element, *, in_gz: bool) -> tuple[float, ...] | None:
    """Red, green and blue in Gazebo; None for a texture or an unknown name."""
    material = materials().get(_named(element))
    if material is None or material.is_textured:
        return None
    rgba = (material.gz_diffuse if in_gz else None) or material.rgba or ()
    return rgba[:3] or None


def _is_similar(element: Element, rgb: tuple[float, ...], material: Material) -> bool:
    """True if the colours are similar, or have the same name."""
    assert material.rgba is not None
    word = _named(element).rpartition("/")[2].lower()
    if material.name and word in material.name.value.lower():
        return True
    pairs = zip(rgb, material.rgba.value, strict=False)  # which has alpha, too
    return all(abs(a - b) <= _TOLERANCE for a, b in pairs)


def _finding(name: str, element: Element, rgb: tuple[float, ...], material: Material) -> Finding:
    assert material.rgba is not None
    called = f"'{material.name.value}' " if material.name else ""
    return Finding(
        element,
        f"link '{name}' is {_named(element)} ({spaced(rgb, 3)}) in Gazebo and "
        f"{called}({spaced(material.rgba.value[:3], 3)}) in the URDF",
        related=(Related(material.rgba.span, "the colour in the URDF"),),
        group_key="colour",
    )
