"""Writing GLB (binary glTF 2.0).

glTF says that y is upwards, but the readers of URDF (assimp in RViz and Gazebo, trimesh) take the
coordinates as they are and turn nothing. So does this writer: z stays upwards in the robot.
"""

from __future__ import annotations

from urdfkit.meshes.geometry import Mesh
from urdfkit.meshes.shading import shaded


def encode(mesh: Mesh, name: str) -> dict[str, bytes]:
    """The bytes of a GLB with materials, normals and textures inside."""
    from urdfkit.meshes.writers.bridge import as_scene

    scene = as_scene(mesh._replace(parts=tuple(map(shaded, mesh.parts))))
    return {name: bytes(scene.export(file_type="glb", include_normals=True))}
