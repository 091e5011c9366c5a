"""The materials of the surfaces of a robot: of its URDF, its meshes, or Gazebo's."""

from typing import NamedTuple

from urdfkit.mesh import geometry
from urdfkit.robot.assets.colours import Colours
from urdfkit.robot.assets.mesh_files import MeshFiles
from urdfkit.robot.link import Body, Material
from urdfkit.robot.model import RobotModel
from urdfkit.ros.catalog.materials import materials
from urdfkit.ros.gazebo.values import text_of

Colour = tuple[float, float, float, float]


class SurfaceMaterial(NamedTuple):
    """The colour or the texture of a surface."""

    rgba: Colour  # components from 0 to 1, as written (sRGB); multiplied with the texture
    texture: str | bytes | None = None  # path or bytes of an image; None without a texture
    #: True for overlays, which are not part of the robot: they cast no shadows, and are visible
    #: through other surfaces.
    overlay: bool = False


#: Surfaces without a material.
PLAIN = SurfaceMaterial((0.72, 0.74, 0.77, 1.0))
#: Placeholders for missing meshes; this name stands for stripes.
STRIPES = "urdfkit:stripes"
PLACEHOLDER = SurfaceMaterial((1.0, 0.48, 0.0, 1.0), STRIPES)
#: Collisions, translucent if visuals are drawn, too.
COLLISION = SurfaceMaterial((0.93, 0.42, 0.12, 0.45))


class ModelMaterials:
    """The materials of one model.

    A material of the URDF overrides materials in a mesh file, as in RViz. Without both, the link's
    Gazebo material is used.

    Args:
        see_through: True for translucent collisions.
    """

    def __init__(self, model: RobotModel, files: MeshFiles, *, see_through: bool = True) -> None:
        self._files = files
        self._collision = COLLISION if see_through else SurfaceMaterial((*COLLISION.rgba[:3], 1.0))
        self._colours = Colours(model)
        self._gazebo = {
            block.get("reference"): text_of(material)
            for block in model.gazebo
            if (material := block.child("material"))
        }

    def of(
        self, link: str, role: str, body: Body, embedded: geometry.MeshMaterial | None
    ) -> SurfaceMaterial:
        """The material of triangles.

        Args:
            role: ``visual`` or ``collision``.
        """
        if role == "collision":
            return self._collision
        own = self._colours.of(body)
        if own is not None:
            return self._written(own)
        if embedded is not None:
            return SurfaceMaterial(embedded.rgba, embedded.texture)
        if link in self._gazebo:
            known = materials().get(self._gazebo[link])
            if known and known.rgba:
                return SurfaceMaterial(_colour(known.rgba))
        return PLAIN

    def _written(self, material: Material) -> SurfaceMaterial:
        """The material of a ``<material>``; if its texture is missing, only the colour."""
        texture = None
        if material.texture is not None:
            texture = self._files.find(material.texture)
        if material.rgba is None:
            return SurfaceMaterial(PLAIN.rgba if texture is None else (1.0, 1.0, 1.0, 1.0), texture)
        return SurfaceMaterial(_colour(material.rgba.value), texture)


def _colour(values: tuple[float, ...]) -> Colour:
    r, g, b, a = (min(max(part, 0.0), 1.0) for part in (*values, 1.0, 1.0, 1.0, 1.0)[:4])
    return (r, g, b, a)
