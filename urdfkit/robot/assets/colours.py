"""Which colour a visual has, as the readers of URDF find it."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import chain

from urdfkit.robot.model import Body, Link, Material, RobotModel


class Colours:
    """The materials of a model by name.

    urdfdom keeps the first definition of a name, at the top of the robot or in a visual; every
    other visual with the name gets it.
    """

    def __init__(self, model: RobotModel) -> None:
        self._model = model
        self._named: dict[str, Material] = {}
        for material in chain(
            model.materials, (m for _, body in _seen(model) if (m := body.material))
        ):
            if material.name and (material.rgba or material.texture):
                self._named.setdefault(material.name.value, material)

    def of(self, body: Body) -> Material | None:
        """The material of a visual that says how it looks; None if nothing does."""
        material = body.material
        if material is None:
            return None
        named = self._named.get(material.name.value) if material.name else None
        return named or (material if material.rgba or material.texture else None)

    def visuals(self) -> Iterator[tuple[Link, Body, Material]]:
        """The visuals that have a colour or a texture, each with the material that gives it."""
        for link, body in _seen(self._model):
            material = self.of(body)
            if material is not None:
                yield link, body, material


def _seen(model: RobotModel) -> Iterator[tuple[Link, Body]]:
    for link in model.links:
        for body in link.visuals:
            yield link, body
