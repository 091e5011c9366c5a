"""Mesh simplification for the 3D view of robots with too many triangles for a browser.

Vertices in one cell of a grid are merged (Rossignac, Borrel: Multi-resolution 3D approximations,
1993): rough, but fast and robust for any mesh.
"""

from collections.abc import Sequence

import numpy as np

from urdfkit.render.scene import SceneItem

#: Numbers of cells along the longest edge of a surface, tried in this order.
CELLS = (1024, 512, 256, 128, 64, 32)
#: Surfaces of fewer triangles are not simplified.
MIN_FACES = 2000


def coarsened(items: Sequence[SceneItem], limit: int) -> Sequence[SceneItem]:
    """Surfaces simplified to about ``limit`` triangles together; unchanged if they have fewer."""
    for cells in CELLS:
        if sum(len(item.faces) for item in items) <= limit:
            break
        items = [_clustered(item, cells) if len(item.faces) > MIN_FACES else item for item in items]
    return items


def _clustered(item: SceneItem, cells: int) -> SceneItem:
    """A surface with one vertex in each cell, and flat faces."""
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
