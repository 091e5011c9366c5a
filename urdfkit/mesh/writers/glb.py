"""Writing GLB (binary glTF 2.0).

glTF says that y is upwards. Gazebo, RViz before 15.1.4, assimp and trimesh take the numbers as they
are, and for them z stays upwards here, as in every other format; newer RViz, Drake and Blender turn
what they read by 90 degrees. No file suits both, so `NOTE` goes with each that is written.
"""

from __future__ import annotations

from urdfkit.mesh.geometry import Mesh
from urdfkit.mesh.normals import shaded

#: What a user of the file has to know.
NOTE = (
    "glTF means y upwards: Gazebo takes the numbers as they are, RViz from 15.1.4 on turns them; "
    "COLLADA and OBJ mean the same to both"
)


def encode(mesh: Mesh, name: str) -> dict[str, bytes]:
    """The bytes of a GLB with materials, normals and textures inside."""
    from urdfkit.mesh.writers.bridge import as_scene

    scene = as_scene(mesh._replace(parts=tuple(map(shaded, mesh.parts))))
    return {name: bytes(scene.export(file_type="glb", include_normals=True))}
