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

#: Least major versions, as in pyproject.toml. A sourced ROS may put older ones in front.
_LEAST_VERSIONS = {"pinocchio": 4, "coal": 3}

#: Most collision bodies that are compared; a humanoid with decomposed meshes has half as many.
MAX_BODIES = 2000


def need_coal() -> None:
    """Import coal.

    Raises:
        Unavailable: coal is not installed, or too old.
    """
    _need("coal", "coal")


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
        Unavailable: Pinocchio is not installed, or too old, or cannot represent the robot.
    """
    _need("Pinocchio", "pinocchio")
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


def _need(library: str, module: str) -> None:
    """Import a library of a supported version.

    Raises:
        Unavailable: it is not installed, cannot be imported, or is too old.
    """
    try:
        found = import_module(module)
    except ImportError as error:
        raise Unavailable(_not_installed(library, error)) from error
    except Exception as error:  # such as a RuntimeError, if it does not fit another library
        raise Unavailable(f"{library} cannot be imported: {error}") from error
    from urdfkit.core.installation import install_command, older

    least = _LEAST_VERSIONS[module]
    if old := older(found, least):
        raise Unavailable(
            f"{library} {old} is older than {least}: {install_command('dynamics')}, "
            "or take it off PYTHONPATH"
        )


def _not_installed(library: str, why: object) -> str:
    from urdfkit.core.installation import install_command

    return f"{library} is not installed ({why}): {install_command('dynamics')}"
