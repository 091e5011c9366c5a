"""The colour of a visual, as URDF parsers determine it."""

from collections.abc import Iterator
from itertools import chain

from urdfkit.robot.link import Body, Link, Material
from urdfkit.robot.model import RobotModel


class Colours:
    """The materials of a model by name.

    urdfdom keeps the first definition of a name, of the robot or in a visual, and applies it to all
    visuals with the name. A material with an empty name applies to its visual only.
    """

    def __init__(self, model: RobotModel) -> None:
        self._model = model
        self._named: dict[str, Material] = {}
        for material in chain(
            model.materials, (m for _, body in _visuals(model) if (m := body.material))
        ):
            if _name(material) and (material.rgba or material.texture):
                self._named.setdefault(_name(material), material)

    def of(self, body: Body) -> Material | None:
        """The material with the colour or texture of a visual; None without one."""
        material = body.material
        if material is None:
            return None
        named = self._named.get(_name(material))
        return named or (material if material.rgba or material.texture else None)

    def visuals(self) -> Iterator[tuple[Link, Body, Material]]:
        """The visuals with a colour or texture, each with its material."""
        for link, body in _visuals(self._model):
            material = self.of(body)
            if material is not None:
                yield link, body, material


def _name(material: Material) -> str:
    return material.name.value if material.name else ""


def _visuals(model: RobotModel) -> Iterator[tuple[Link, Body]]:
    for link in model.links:
        for body in link.visuals:
            yield link, body
