"""A model or a mesh of the world that a launch file starts is not found.

- A mesh of a model or package of the workspace does not exist (warning), or is in the home
  directory of a user, which other computers do not have.
- A model that the world includes with `model://` is not in the workspace (info), or is misspelt; or
  gz sim loads `model://sun` or `model://ground_plane`, which only Gazebo Classic downloads: the
  world is not loaded unless the resource path contains the model (warning).
- The `model.config` of a model is missing, or names a file that does not exist (warning).
- A model of the workspace is in none of the directories that launch files and packages add to the
  resource path of gz sim, or only in that of `IGN_GAZEBO_RESOURCE_PATH`, from which Gazebo Harmonic
  takes no models (warning).

Sources:
    gz-sim, Server.cc: https://github.com/gazebosim/gz-sim/blob/gz-sim8/src/Server.cc
    Gazebo, migration of SDF: https://github.com/gazebosim/gz-sim/blob/gz-sim8/tutorials/migration_sdf.md
"""

import os
import re

from urdfkit.checks.worlds.model_files import unreadable_models
from urdfkit.checks.worlds.model_paths import FORMER, VARIABLE, resource_path
from urdfkit.checks.worlds.opened_worlds import OpenedWorld, opened_worlds
from urdfkit.checks.worlds.world_values import is_generated
from urdfkit.core import disk
from urdfkit.core.suggest import TYPO, nearest
from urdfkit.lint.rules import Context, Finding, Findings, Need, Related, Severity, rule
from urdfkit.ros.catalog import data
from urdfkit.ros.gazebo.worlds import Models, World, model_name
from urdfkit.ros.launch.samples import WORLD_LAUNCH, world_files
from urdfkit.ros.launch.worlds import GZ
from urdfkit.workspace.gitignore import is_ignored
from urdfkit.workspace.resolve import Resolver

NAME = "launch/robot.launch.py"
BAD = WORLD_LAUNCH
GOOD = BAD.replace("bad.sdf", "good.sdf")
FILES = world_files(
    "<include><uri>model://big_shlef</uri></include>",
    "<include><uri>model://big_shelf</uri></include>",
) | {
    "models/big_shelf/model.config": b"<model/>",
    "package.xml": b"<package><name>cart</name><export>"
    b'<gazebo_ros gazebo_model_path="${prefix}/models"/></export></package>',
}

_OF_A_USER = re.compile(r"(file://)?/(home|Users)/")
_FUEL = "https://fuel.gazebosim.org/1.0/OpenRobotics/models/"


@rule(Severity.WARNING, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    models = Models(context.resolver, context.source.path)
    for opened in opened_worlds(context):
        if opened.world is not None:
            yield from opened.noted(_missing_meshes(opened, opened.world, models, context))
            yield from opened.noted(_missing_models(opened, opened.world, models))
            yield from opened.noted(unreadable_models(opened.world, models, context.resolver))
            if opened.started.generation == GZ:
                yield from opened.noted(_not_on_the_path(opened.world, models, context))


def _missing_models(opened: OpenedWorld, world: World, models: Models) -> Findings:
    """Missing models, only with a typo or a replacement: other machines may have more models."""
    missing = [(at, uri) for at, uri in world.includes if model_name(uri) and not models.has(uri)]
    for at, uri in missing:
        name = model_name(uri)
        fuel = data("worlds")["models"].get(name)
        # Gazebo has a ground_plane: my_ground_plane is another one.
        if suggested := None if fuel else nearest(name, models.directories, TYPO):
            message = f"model '{uri}' is not found; did you mean '{suggested}'?"
            help = f"write model://{suggested}"
        elif fuel and opened.started.generation == GZ:
            message = f"gz sim does not have '{uri}', which Gazebo Classic downloads"
            help = f"write {_FUEL}{fuel}, or the model itself"
        elif opened.started.generation == GZ:
            message = f"model '{uri}' is not in the workspace: without it the world is not loaded"
            help = "add its parent directory to GZ_SIM_RESOURCE_PATH, or write the model itself"
        else:
            continue
        severity = None if suggested or fuel else Severity.INFO
        yield Finding(at, message, help, severity=severity)


def _not_on_the_path(world: World, models: Models, context: Context) -> Findings:
    """Models of the workspace that gz sim does not find."""
    included = [
        (at, uri, directories)
        for at, uri in world.includes
        if (directories := models.directories.get(model_name(uri)))
    ]
    path = resource_path(context) if included else None
    if path is None:
        return
    for at, uri, directories in included:
        if any(map(path.contains, directories)):
            continue
        parents = {os.path.dirname(directory) for directory in directories}
        setting = next((path.former[parent] for parent in parents if parent in path.former), None)
        if setting:
            message = f"gz sim does not find '{uri}': it does not read {FORMER}"
            note = Related(at.span, "the world includes it here")
            yield Finding(setting, message, f"write {VARIABLE}", related=(note,))
        else:
            message = (
                f"gz sim does not find '{uri}': no launch file adds its directory to {VARIABLE}"
            )
            where = _in_package(min(parents), context.resolver)
            yield Finding(at, message, f"add {where} to {VARIABLE} in the launch file")


def _in_package(directory: str, resolver: Resolver) -> str:
    """A directory relative to that of its package, with the name of the package."""
    name, top = resolver.packages.enclosing(directory) or ("", os.path.dirname(directory))
    return os.path.normpath(os.path.join(name, os.path.relpath(directory, top)))


def _missing_meshes(
    opened: OpenedWorld, world: World, models: Models, context: Context
) -> Findings:
    """Meshes of models and packages of the workspace that do not exist."""
    for element in world.elements:
        uri = element.child("uri") if element.tag == "mesh" else None
        text = uri.text.strip() if uri is not None else ""
        if uri is None or not text or is_generated(text):
            continue
        if _OF_A_USER.match(text):
            yield Finding(
                uri,
                f"{opened.title}: mesh '{text}' exists on one computer only",
                "write model://, or a path relative to the world",
                group_key=text,
            )
        elif _is_missing(text, opened.path, models, context.resolver):
            yield Finding(
                uri,
                f"{opened.title}: mesh '{text}' is not found",
                "fix the path, or add the file",
            )


def _is_missing(uri: str, world: str, models: Models, resolver: Resolver) -> bool:
    """False for models and packages of others, which the robot's computer may have."""
    scheme, _, path = uri.rpartition("://")
    if not scheme and not os.path.isabs(uri):
        return not _exists(f"{os.path.dirname(world)}/{uri}")
    owner, _, file = path.partition("/")
    directories = models.directories.get(owner, []) if scheme == "model" else []
    # A directory with the name alone may be ``urdf``.
    packages = resolver.packages.candidates(owner, world)
    is_own = directories or any(package.certain for package in packages)
    if scheme not in ("model", "package") or not file or not is_own:
        return False
    is_found = resolver.locate(uri, world).path is not None
    return not is_found and not any(_exists(f"{directory}/{file}") for directory in directories)


def _exists(path: str) -> bool:
    """True for files that Git ignores, too, which are made by a build."""
    return disk.is_file(path) or is_ignored(path)
