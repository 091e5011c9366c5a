"""Open edges that belong together: points that nearly meet."""

import numpy as np
from scipy.spatial import cKDTree

from urdfkit.mesh.edges import Edges
from urdfkit.mesh.grouping import components
from urdfkit.mesh.repair.soup import TriangleSoup


def weld_rims(soup: TriangleSoup, tolerance: float) -> TriangleSoup:
    """Points of open edges that are nearer to each other than a tolerance made one.

    Points that are not on an open edge stay as they are: what is closed is not to be changed.
    """
    if not len(soup.faces):
        return soup
    edges = Edges(soup.faces)
    rim = np.unique(edges.ends[edges.is_open])
    pairs = cKDTree(soup.points[rim]).query_pairs(tolerance, output_type="ndarray")
    if not len(pairs):
        return soup
    return soup.merged(components(len(soup.points), rim[pairs]))
