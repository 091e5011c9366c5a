"""Requirements of the rules about dynamics, collisions and simulations, otherwise skipped."""

from __future__ import annotations

from importlib import import_module

from urdfkit.core import libraries
from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.errors import Unavailable, UrdfkitError

if TYPE_CHECKING:
    from collections.abc import Callable

    from urdfkit.physics.dynamics.robot import Dynamics
    from urdfkit.physics.verdicts import Simulation
    from urdfkit.robot.assets.mesh_files import MeshFiles
    from urdfkit.robot.model import RobotModel
    from urdfkit.robot.tree import KinematicTree

#: Most collision bodies that are compared; a humanoid with decomposed meshes has half as many.
MAX_BODIES = 2000


def need_coal() -> None:
    """Import coal.

    Raises:
        Unavailable: coal is not installed.
    """
    try:
        import_module("coal")
    except ImportError as error:
        raise Unavailable(_not_installed("coal", error)) from error


def need_pinocchio() -> None:
    """Require Pinocchio without importing it.

    Raises:
        Unavailable: Pinocchio is not installed.
    """
    if libraries.find("pinocchio") is None:
        raise Unavailable(_not_installed("Pinocchio", "no module 'pinocchio'"))


def dynamics_of(tree: KinematicTree) -> Dynamics:
    """A robot in Pinocchio.

    Raises:
        Unavailable: Pinocchio is not installed, or cannot represent the robot.
    """
    try:
        from urdfkit.physics.dynamics.robot import Dynamics, Unsuitable
    except ImportError as error:
        raise Unavailable(_not_installed("Pinocchio", error)) from error
    try:
        return Dynamics(tree)
    except Unsuitable as reason:
        raise Unavailable(str(reason)) from reason


def simulation_of(
    model: RobotModel, files: MeshFiles, simulate: Callable[[], Simulation]
) -> Simulation:
    """The results of simulations of a robot.

    Raises:
        Unavailable: the robot cannot be simulated.
    """
    names = [body.file for body in model.collisions if body.file]
    if any(files.locate(name).path is None for name in names):
        raise Unavailable("not simulated: mesh files of collisions are missing")
    try:
        return simulate()
    except UrdfkitError as error:
        reason = str(error).partition("; see 'urdfkit check ")[0]
        raise Unavailable(f"not simulated: {reason}") from error


def need_few_bodies(model: RobotModel) -> None:
    """Reject a robot with too many collision bodies to compare.

    Raises:
        Unavailable: the robot has more than `MAX_BODIES`.
    """
    bodies = sum(len(link.collisions) for link in model.links)
    if bodies > MAX_BODIES:
        raise Unavailable(f"{bodies} collision bodies; more than {MAX_BODIES} are not compared")


def _not_installed(library: str, why: object) -> str:
    from urdfkit.core.installation import install_command

    return f"{library} is not installed ({why}): {install_command('dynamics')}"
