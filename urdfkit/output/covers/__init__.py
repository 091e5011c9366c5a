"""Spheres and capsules that cover the links of a robot, as motion planners use."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import TYPE_CHECKING, TypeVar

from urdfkit.core.progress import Progress, silent
from urdfkit.core.record import Record
from urdfkit.lint.context import Context
from urdfkit.lint.loading import read
from urdfkit.output.covers.solids import Solids, solids

if TYPE_CHECKING:
    from urdfkit.mesh.capsule_fitting import Capsules
    from urdfkit.mesh.cover_quality import CoverQuality
    from urdfkit.mesh.sphere_fitting import Spheres
    from urdfkit.robot.shapes import Primitive


class LinkCover(Record):
    """The spheres or capsules of a link."""

    link: str
    shapes: Spheres | Capsules  # in the frame of the link, in m
    quality: CoverQuality


class RobotCover(Record):
    """The spheres or capsules of a robot."""

    links: tuple[LinkCover, ...]  # of links with geometry, in document order
    total: CoverQuality
    #: Sentences on geometry that is omitted or replaced by its hull, with the reason.
    left_out: tuple[str, ...]
    replaced: tuple[str, ...]

    @property
    def facts(self) -> dict[str, object]:
        """The shapes for JSON."""
        return {
            "version": 1,
            "links": [
                {
                    "link": link.link,
                    **link.quality.facts,
                    **{name: values.tolist() for name, values in link.shapes._asdict().items()},
                }
                for link in self.links
            ],
            "total": self.total.facts,
            "left_out": list(self.left_out),
            "replaced": list(self.replaced),
        }


def fit_spheres(
    robot: Context | str | os.PathLike[str],
    *,
    most: int = 100,
    margin: float = 0.01,
    coverage: float = 0.99,
    visual: bool = False,
    progress: Progress | None = None,
) -> RobotCover:
    """Cover the links of a robot with spheres.

    Args:
        robot: a URDF or xacro file, or the result of `urdfkit.read`.
        most: maximum number of spheres, unless there are more links.
        margin: how far a sphere may protrude, in m; exceeded if ``most`` requires it.
        coverage: part of the volume of each link that is covered by spheres, from 0 to 1.
        visual: True to cover the visual geometry instead of the collision geometry.
        progress: called with the number of finished steps and of all steps.

    Raises:
        UrdfkitError: there is no geometry to cover.
    """
    from urdfkit.mesh.sphere_fitting import Covering, fit

    context = robot if isinstance(robot, Context) else read(robot)
    found = solids(context, ("sphere",), visual=visual)
    exact = {name: _spheres(shapes) for name, shapes in found.exact.items()}
    report, steps = progress or silent, 2 * len(found.triangles)
    coverings = {}
    for number, (name, triangles) in enumerate(found.triangles.items(), 1):
        if name not in exact:
            coverings[name] = Covering(triangles, coverage, len(found.triangles))
        report(number, steps)
    fitted = fit(
        [*coverings.values()],
        margin,
        most - sum(len(cover.radii) for cover in exact.values()),
        lambda done: report(steps // 2 + done, steps),
    )
    return _measured(found, {**exact, **dict(zip(coverings, fitted, strict=True))})


def fit_capsules(
    robot: Context | str | os.PathLike[str],
    *,
    most: int = 30,
    margin: float = 0.02,
    coverage: float = 0.99,
    visual: bool = False,
    progress: Progress | None = None,
) -> RobotCover:
    """Cover each link of a robot with one capsule, or a few.

    Args:
        robot: a URDF or xacro file, or the result of `urdfkit.read`.
        most: maximum number of capsules, unless there are more links.
        margin: a link gets another capsule if 5 % of the surface of its capsules that is outside
            protrudes by more, in m, and ``most`` permits it.
        coverage: part of the volume of each link that is covered by capsules, from 0 to 1.
        visual: True to cover the visual geometry instead of the collision geometry.
        progress: called with the number of finished steps and of all steps.

    Raises:
        UrdfkitError: there is no geometry to cover.
    """
    from urdfkit.mesh.capsule_fitting import fit

    context = robot if isinstance(robot, Context) else read(robot)
    found = solids(context, ("sphere", "capsule"), visual=visual)
    exact = {name: _capsules(shapes) for name, shapes in found.exact.items()}
    report, steps = progress or silent, len(found.triangles)
    others = {name: one for name, one in found.triangles.items() if name not in exact}
    fitted = fit(
        [*others.values()],
        coverage=coverage,
        margin=margin,
        most=most - sum(len(cover.radii) for cover in exact.values()),
        report=lambda done: report(len(exact) + done, steps),
    )
    return _measured(found, {**exact, **dict(zip(others, fitted, strict=True))})


_Shapes = TypeVar("_Shapes", "Spheres", "Capsules")


def _measured(found: Solids, covers: Mapping[str, _Shapes]) -> RobotCover:
    from urdfkit.mesh.cover_quality import measure, total

    links = [
        LinkCover(name, covers[name], measure(triangles, covers[name]))
        for name, triangles in found.triangles.items()
    ]
    whole = total([cover.quality for cover in links])
    return RobotCover(tuple(links), whole, tuple(found.left_out), tuple(found.replaced))


def _spheres(shapes: list[Primitive]) -> Spheres:
    from numpy import array

    from urdfkit.mesh.sphere_fitting import Spheres

    centers = array([shape.origin.position for shape in shapes])
    return Spheres(centers, array([shape.radius for shape in shapes]))


def _capsules(shapes: list[Primitive]) -> Capsules:
    from numpy import array

    from urdfkit.mesh.capsule_fitting import Capsules

    ends = [
        [shape.origin.apply((0.0, 0.0, sign * shape.length / 2)) for sign in (-1, 1)]
        for shape in shapes
    ]
    return Capsules(array(ends), array([shape.radius for shape in shapes]))
