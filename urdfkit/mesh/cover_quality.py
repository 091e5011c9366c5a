"""Quality of spheres or capsules that cover a solid, by independent samples and exact triangles."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

import numpy as np

from urdfkit.core.record import Record
from urdfkit.mesh.distance import sample_surface, to_surface
from urdfkit.mesh.geometry import Floats, areas
from urdfkit.mesh.inside import are_inside, points_inside

#: Lines through the inside, points on the surface.
_COLUMNS, _SURFACE = 1200, 3000
_SEED = 23


class Cover(Protocol):
    """Spheres or capsules."""

    @property
    def radii(self) -> Floats:
        """(n,), one for each shape."""

    def distances(self, points: Floats) -> Floats:
        """(n,), distances of points from the nearest shape; negative inside."""

    def on_surfaces(self, random: np.random.Generator) -> Floats:
        """(k, n, 3), points spread evenly over the surface of each shape."""


class CoverQuality(Record):
    """Quality of the spheres or capsules of a link or a robot; the names are cuRobo's.

    Source of the definitions: https://nvlabs.github.io/curobo/latest/reference/sphere_fitting.html
    """

    number: int  # of spheres or capsules
    volume: float  # of the solid, in m^3
    area: float  # of its surface, in m^2
    coverage: float  # part of the inside that lies in a shape, from 0 to 1
    surface_coverage: float  # part of the surface that lies in a shape
    max_uncovered_gap: float  # greatest distance from the surface to the shapes, in m
    #: Distances from the solid of points on the shapes that are outside of it, in m.
    protrusion_mean: float
    protrusion_p95: float
    protrusion_max: float
    protrusions: Floats  # (n,), all distances

    @property
    def facts(self) -> dict[str, float]:
        return {name: value for name, value in self._asdict().items() if name != "protrusions"}


def measure(triangles: Floats, cover: Cover) -> CoverQuality:
    """Compare spheres or capsules with the solid that they cover.

    Args:
        triangles: (m, 3, 3), of closed surfaces in m.
    """
    turned = triangles[:, :, [1, 2, 0]]  # lines along another axis than in the fit
    inside, volume = points_inside(turned, _COLUMNS, _SEED)
    surface, _ = sample_surface(triangles, _SURFACE)
    inner = inside[:, [2, 0, 1]] if len(inside) else surface
    gaps = cover.distances(surface)
    on = cover.on_surfaces(np.random.default_rng(_SEED)).reshape(-1, 3)
    outside = on[~are_inside(turned, on[:, [1, 2, 0]])]
    faces = np.arange(3 * len(triangles)).reshape(-1, 3)
    beyond = to_surface(outside, triangles.reshape(-1, 3), faces)
    return CoverQuality(
        len(cover.radii),
        volume,
        float(areas(triangles.reshape(-1, 3), faces).sum()),
        float((cover.distances(inner) <= 0).mean()),
        float((gaps <= 0).mean()),
        max(0.0, float(gaps.max())),
        *_protrusions(beyond),
    )


def total(parts: Sequence[CoverQuality]) -> CoverQuality:
    """The quality for all links: coverage by volume and by area, protrusion over all points."""
    volumes, surfaces = np.array([(part.volume, part.area) for part in parts]).T
    return CoverQuality(
        sum(part.number for part in parts),
        float(volumes.sum()),
        float(surfaces.sum()),
        float(np.average([part.coverage for part in parts], weights=volumes)),
        float(np.average([part.surface_coverage for part in parts], weights=surfaces)),
        max(part.max_uncovered_gap for part in parts),
        *_protrusions(np.concatenate([part.protrusions for part in parts])),
    )


def _protrusions(beyond: Floats) -> tuple[float, float, float, Floats]:
    """Mean, 95th percentile and greatest of some distances, and the distances."""
    values = beyond if len(beyond) else np.zeros(1)
    return float(values.mean()), float(np.quantile(values, 0.95)), float(values.max()), beyond
