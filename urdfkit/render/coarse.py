"""Fewer triangles for the 3D view of a robot that has more than a browser turns with pleasure.

Vertices in one cell of a grid become one (Rossignac, Borrel: Multi-resolution 3D approximations,
1993): crude, but fast, and whatever a mesh is like.
"""

from collections.abc import Sequence

import numpy as np

from urdfkit.render.scene import SceneItem

#: Cells along the longest edge of a surface, until few triangles are left.
CELLS = (1024, 512, 256, 128, 64, 32)
#: Surfaces of fewer triangles stay as they are.
FEW = 2000


def coarsened(items: Sequence[SceneItem], limit: int) -> Sequence[SceneItem]:
    """Surfaces with a number of triangles in all, or near it; the same if they have fewer.

    Args:
        limit: how many triangles are enough.
    """
    for cells in CELLS:
        if sum(len(item.faces) for item in items) <= limit:
            break
        items = [_clustered(item, cells) if len(item.faces) > FEW else item for item in items]
    return items


def _clustered(item: SceneItem, cells: int) -> SceneItem:
    """A surface with one vertex in each cell; its faces are flat."""
    low = item.vertices.min(axis=0)
    size = max(float(np.ptp(item.vertices, axis=0).max()), 1e-9)
    x, y, z = ((item.vertices - low) * (cells / size)).astype(np.int64).T
    wide = cells + 1
    _, first, place = np.unique((x * wide + y) * wide + z, return_index=True, return_inverse=True)
    faces = place.reshape(-1)[item.faces].astype(np.int32)
    a, b, c = faces.T
    return item._replace(
        vertices=item.vertices[first],
        faces=faces[(a != b) & (b != c) & (c != a)],
        normals=None,
        uv=None if item.uv is None else item.uv[first],
        colors=None if item.colors is None else item.colors[first],
    )
