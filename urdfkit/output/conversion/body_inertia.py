"""Pseudo-inertia matrices of links that are fixed together, and their comparison."""

import numpy as np

from urdfkit.core.spatial import Transform
from urdfkit.mesh.geometry import Floats
from urdfkit.mesh.transforms import homogeneous
from urdfkit.robot.link import Link
from urdfkit.robot.rigid_bodies import properties_of

#: Masses in kg and moments in kg·m² below this count as zero.
_ZERO = 1e-15


def pseudo_inertia(mass: float, center: Floats, tensor: Floats, frame: Transform) -> Floats:
    """The pseudo-inertia in another frame, (4, 4); it is additive.

    Its blocks are the second moments, the first moments and the mass.
    """
    second = np.trace(tensor) / 2 * np.eye(3) - tensor + mass * np.outer(center, center)
    matrix = np.block(
        [[second, mass * center[:, None]], [mass * center[None, :], np.array([[mass]])]]
    )
    transform = homogeneous(*frame)
    return np.asarray(transform @ matrix @ transform.T)


def of_link(link: Link, frame: Transform) -> Floats:
    """Pseudo-inertia of a link, (4, 4), in the parent of ``frame``."""
    mass, center, tensor = properties_of(link, Transform())
    return pseudo_inertia(mass, np.array(center), np.array(tensor.rows), frame)


def about_center(ours: Floats, theirs: Floats) -> tuple[Floats, Floats]:
    """Two pseudo-inertias, both about the centre of mass of the first."""
    translation = np.eye(4)
    if ours[3, 3] > _ZERO:
        translation[:3, 3] = -ours[:3, 3] / ours[3, 3]
    return translation @ ours @ translation.T, translation @ theirs @ translation.T


def difference(ours: Floats, theirs: Floats) -> float:
    """The largest difference of two pseudo-inertias, relative to the first.

    Moments are relative to the largest second moment and the mass, whatever the unit of length:
    a small part has a small tensor.
    """
    second, mass = max(float(np.abs(ours[:3, :3]).max()), _ZERO), max(abs(ours[3, 3]), _ZERO)
    scale = np.sqrt([second, second, second, mass])
    largest = float(np.abs((ours - theirs) / np.outer(scale, scale)).max())
    return largest if np.isfinite(largest) else float("inf")
