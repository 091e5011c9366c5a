"""Merging of open edges whose points nearly coincide."""

import numpy as np
from scipy.spatial import cKDTree

from urdfkit.mesh.edges import Edges
from urdfkit.mesh.grouping import components
from urdfkit.mesh.repair.soup import TriangleSoup


def weld_rims(soup: TriangleSoup, tolerance: float) -> TriangleSoup:
    """Merge points of open edges within a tolerance; closed parts of the surface do not change."""
    edges = Edges(soup.faces)
    rim = np.unique(edges.ends[edges.is_open])
    pairs = cKDTree(soup.points[rim]).query_pairs(tolerance, output_type="ndarray")
    if not len(pairs):
        return soup
    return soup.merge(components(len(soup.points), rim[pairs]))
