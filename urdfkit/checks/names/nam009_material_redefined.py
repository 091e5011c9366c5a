"""Visuals give one material name two colours.

A material's name holds for the whole robot. urdfdom (RViz, MoveIt, Gazebo, Pinocchio) keeps the
colour that it reads first, one defined below `<robot>` before all, and paints every part with it;
other readers take each part's own. Give each colour its own name.

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
    urdfdom, model.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/model.cpp
"""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, rule
from urdfkit.robot.model import Link, Material, RobotModel
from urdfkit.robot.samples import link_xml, visual_xml
from urdfkit.text.diagnostic import Related, Severity

BAD = link_xml(
    "base",
    visual_xml(
        '<box size="0.4 0.3 0.1"/>', '<material name="body"><color rgba="1 1 1 1"/></material>'
    ),
    visual_xml(
        '<sphere radius="0.1"/>', '<material name="body"><color rgba="1 0 0 1"/></material>'
    ),
)
GOOD = BAD.replace('"body"><color rgba="1 0', '"dome"><color rgba="1 0')


@rule(Severity.WARNING, help="give each colour its own name")
def check(subject: Subject) -> Findings:
    model = subject.model
    first: dict[str, Material] = {}
    for material in model.materials:
        if material.name and _look(material) != (None, None):
            first.setdefault(material.name.value, material)
    for link, material in _of_visuals(model):
        look = _look(material)
        if not material.name or not material.name.value or look == (None, None):
            continue
        known = first.setdefault(material.name.value, material)
        if look != _look(known):
            yield Finding(
                material.rgba or material.texture or material.at,
                f"link '{link.name}': material '{material.name.value}' is {_shown(look)} here and "
                f"{_shown(_look(known))} before; readers keep the first",
                related=(Related(known.at.span, "the first"),),
                alike=material.name.value,
            )


def _of_visuals(model: RobotModel) -> Iterator[tuple[Link, Material]]:
    for link in model.links:
        for body in link.visuals:
            if body.material:
                yield link, body.material


def _look(material: Material) -> tuple[tuple[float, ...] | None, str | None]:
    """Colour and texture; None where there is none to read."""
    rgba, texture = material.rgba, material.texture
    return rgba.value if rgba else None, texture.value if texture else None


def _shown(look: tuple[tuple[float, ...] | None, str | None]) -> str:
    rgba, texture = look
    return texture or " ".join(f"{value:g}" for value in rgba or ())
