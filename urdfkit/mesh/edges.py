"""The edges of a triangle mesh and the faces that share them."""

from functools import cached_property

import numpy as np

from urdfkit.mesh.geometry import Flags, Integers
from urdfkit.mesh.grouping import components


class Edges:
    """The edges of faces whose vertices are welded.

    Attributes:
        faces: (m, 3), indices of vertices.
        of_face: (m, 3), index of the edge from each corner of each face to the next corner.
        ends: (e, 2), the vertices of each edge, the smaller index first.
        count: (e,), number of faces at each edge.
    """

    def __init__(self, faces: Integers) -> None:
        self.faces = faces
        following = faces[:, [1, 2, 0]]
        low, high = np.minimum(faces, following), np.maximum(faces, following)
        number = int(high.max(initial=0)) + 1
        keys, edge, self.count = np.unique(
            (low * number + high).reshape(-1), return_inverse=True, return_counts=True
        )
        self.ends = np.stack([keys // number, keys % number], axis=1)
        self.of_face = edge.reshape(-1, 3)

    @property
    def is_open(self) -> Flags:
        """(e,), True for edges of one face."""
        return np.asarray(self.count == 1)

    @property
    def is_non_manifold(self) -> Flags:
        """(e,), True for edges of more than two faces."""
        return np.asarray(self.count > 2)

    @property
    def is_unmatched(self) -> Flags:
        """(e,), True for edges of more than two faces that do not pair up.

        Where bodies touch, an edge has four faces, two in each direction, which is valid.
        """
        return np.asarray((self.count > 2) & self.is_unpaired)

    @property
    def is_inconsistent(self) -> Flags:
        """(e,), True for edges whose two faces traverse them in the same direction."""
        return np.asarray((self.count == 2) & self.is_unpaired)

    @cached_property
    def is_unpaired(self) -> Flags:
        """(e,), True for edges that more faces traverse in one direction than in the other."""
        upwards = self.faces < self.faces[:, [1, 2, 0]]
        signs = np.where(upwards, 1.0, -1.0).reshape(-1)
        balance = np.bincount(self.of_face.reshape(-1), signs, len(self.count))
        return np.asarray(balance != 0)

    @cached_property
    def pairs(self) -> Integers:
        """(k, 2), the faces of each edge that has exactly two."""
        order = np.argsort(self.of_face.reshape(-1), kind="stable")
        starts = np.concatenate([[0], np.cumsum(self.count)[:-1]])[self.count == 2]
        return np.column_stack([order[starts] // 3, order[starts + 1] // 3]).astype(np.int64)

    @cached_property
    def bodies(self) -> Integers:
        """(m,), the number of the edge-connected piece that each face belongs to."""
        order = np.argsort(self.of_face.reshape(-1))  # in any order of the faces of an edge
        edge, face = self.of_face.reshape(-1)[order], order // 3
        same = edge[1:] == edge[:-1]
        links = np.column_stack([face[:-1][same], face[1:][same]])
        least = components(len(self.faces), links)  # the smallest index in the component of each
        number = np.cumsum(least == np.arange(len(least))) - 1
        return np.asarray(number[least], dtype=np.int64)


def have_distinct_corners(faces: Integers) -> Flags:
    """(m,), True for triangles whose corners are three different vertices."""
    a, b, c = faces.T
    return np.asarray((a != b) & (b != c) & (c != a))
