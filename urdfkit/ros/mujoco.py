"""What a URDF tells MuJoCo in its ``<mujoco>`` element, and where MuJoCo looks for its meshes."""

from __future__ import annotations

import os

from urdfkit.core.record import Record
from urdfkit.robot.inertia import MassProperties, principal_axes, rotated
from urdfkit.robot.model import RobotModel, Tensor
from urdfkit.text.document import Element


class Compiler(Record):
    """The settings of MuJoCo's compiler that change how a robot is read, with their defaults.

    Source: https://mujoco.readthedocs.io/en/stable/XMLreference.html#compiler
    """

    mesh_directory: str = ""  # of the mesh files; relative to the URDF, or absolute
    #: True if of the name of a mesh only what follows the last slash counts.
    strips_path: bool = False
    drops_visuals: bool = True  # True if visuals, and their meshes, are not loaded
    #: True if moments that violate the triangle inequality become equal.
    balances_inertia: bool = False
    #: least_mass and least_moment: what links have at least, in kg and kg·m².
    least_mass: float = 0.0
    least_moment: float = 0.0
    fuses_static: bool = True  # True if what no joint moves becomes part of the body above
    #: True if every mass is computed from shapes, whatever is written.
    inertia_from_geometry: bool = False

    def bounded(self, given: MassProperties) -> MassProperties:
        """What MuJoCo takes the mass properties of a link for, before links are merged."""
        moments, axes = principal_axes(given.tensor)
        low, middle, high = (max(moment, self.least_moment) for moment in moments)
        if self.balances_inertia and low + middle < high:
            low = middle = high = (low + middle + high) / 3
        if (low, middle, high) == moments:
            return given._replace(mass=max(given.mass, self.least_mass))
        tensor = rotated(Tensor(low, 0.0, 0.0, middle, 0.0, high), axes)
        return MassProperties(max(given.mass, self.least_mass), given.center, tensor)

    def mesh_path(self, filename: str, urdf: str) -> tuple[str, str]:
        """The directory in which MuJoCo looks for a mesh that a URDF names, and its path there."""
        name = filename.replace("\\", "/")
        if self.strips_path:
            name = name.rpartition("/")[2]
        return os.path.join(os.path.dirname(os.path.abspath(urdf)), self.mesh_directory), name


def compiler_of(model: RobotModel) -> Compiler:
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
