"""What a URDF tells MuJoCo in its ``<mujoco>`` element, and where MuJoCo looks for its meshes."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

from urdfkit.core.record import Record

if TYPE_CHECKING:
    from urdfkit.robot.model import RobotModel
    from urdfkit.text.document import Element


class Compiler(Record):
    """The settings of MuJoCo's compiler that change how a robot is read, with their defaults.

    Source: https://mujoco.readthedocs.io/en/stable/XMLreference.html#compiler

    Attributes:
        mesh_directory: of the mesh files; relative to the URDF, or absolute.
        strips_path: True if of the name of a mesh only what follows the last slash counts.
        drops_visuals: True if visuals, and their meshes, are not loaded.
        balances_inertia: True if moments that violate the triangle inequality become equal.
        least_mass, least_moment: what links have at least, in kg and kg·m².
    """

    mesh_directory: str = ""
    strips_path: bool = False
    drops_visuals: bool = True
    balances_inertia: bool = False
    least_mass: float = 0.0
    least_moment: float = 0.0

    def mesh_path(self, filename: str, urdf: str) -> tuple[str, str]:
        """The directory in which MuJoCo looks for a mesh that a URDF names, and its path there."""
        name = filename.replace("\\", "/")
        if self.strips_path:
            name = name.rpartition("/")[2]
        return os.path.join(os.path.dirname(os.path.abspath(urdf)), self.mesh_directory), name


def compiler_of(model: RobotModel) -> Compiler:
    """The settings in a model."""
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
    )


def _flag(element: Element, name: str, *, default: bool) -> bool:
    return {"true": True, "false": False}.get(element.get(name) or "", default)


def _number(element: Element, name: str) -> float:
    try:
        return float(element.get(name) or 0)
    except ValueError:
        return 0.0
