"""Settings of MuJoCo in the ``<mujoco>`` element of a URDF, and its search for meshes."""

from __future__ import annotations

import os

from urdfkit.core.record import Record
from urdfkit.robot.inertia import MassProperties, principal_axes, rotated
from urdfkit.robot.link import Tensor
from urdfkit.robot.model import RobotModel
from urdfkit.text.document import Element


class Compiler(Record):
    """Settings of MuJoCo's compiler that change the import of a robot, with their defaults.

    Source: https://mujoco.readthedocs.io/en/stable/XMLreference.html#compiler
    """

    mesh_directory: str = ""  # of the mesh files; relative to the URDF, or absolute
    #: True if only the part of a mesh name after the last slash is used.
    strips_path: bool = False
    drops_visuals: bool = True  # True if visuals and their meshes are not loaded
    #: True if moments that violate the triangle inequality become equal.
    balances_inertia: bool = False
    #: least_mass and least_moment: lower bounds for links, in kg and kg·m².
    least_mass: float = 0.0
    least_moment: float = 0.0
    fuses_static: bool = True  # True if links without a moving joint are merged into the body above
    #: True if every mass is computed from shapes, ignoring ``<inertial>``.
    inertia_from_geometry: bool = False

    def bounded(self, declared: MassProperties) -> MassProperties:
        """MuJoCo's mass properties of a link, before links are merged."""
        moments, axes = principal_axes(declared.tensor)
        low, middle, high = (max(moment, self.least_moment) for moment in moments)
        if self.balances_inertia and low + middle < high:
            low = middle = high = (low + middle + high) / 3
        if (low, middle, high) == moments:
            return declared._replace(mass=max(declared.mass, self.least_mass))
        tensor = rotated(Tensor(low, 0.0, 0.0, middle, 0.0, high), axes)
        return MassProperties(max(declared.mass, self.least_mass), declared.center, tensor)

    def mesh_path(self, filename: str, urdf: str) -> tuple[str, str]:
        """The directory in which MuJoCo searches for a mesh, and its path there."""
        name = filename.replace("\\", "/")
        if self.strips_path:
            name = name.rpartition("/")[2]
        return os.path.join(os.path.dirname(os.path.abspath(urdf)), self.mesh_directory), name


def compiler_of(model: RobotModel) -> Compiler:
    """The settings in a URDF; the defaults for those that are missing or no values."""
    block = model.document.root.child("mujoco")
    element = block.child("compiler") if block else None
    if element is None:
        return Compiler()
    return Compiler(
        element.get("meshdir") or element.get("assetdir") or "",
        _flag(element, "strippath", default=False),
        _flag(element, "discardvisual", default=True),
        _flag(element, "balanceinertia", default=False),
        _number(element, "boundmass"),
        _number(element, "boundinertia"),
        _flag(element, "fusestatic", default=True),
        element.get("inertiafromgeom") == "true",
    )


def _flag(element: Element, name: str, *, default: bool) -> bool:
    return {"true": True, "false": False}.get(element.get(name) or "", default)


def _number(element: Element, name: str) -> float:
    try:
        return float(element.get(name) or 0)
    except ValueError:
        return 0.0
