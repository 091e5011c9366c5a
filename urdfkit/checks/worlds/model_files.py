"""The file that Gazebo reads of a model's directory: ``model.config`` names it."""

import os

from urdfkit.core import disk
from urdfkit.lint.rules import Finding, Findings, Related
from urdfkit.ros.gazebo.worlds import Models, World, model_name
from urdfkit.text.document import Element
from urdfkit.text.xml_reader import read_as_tinyxml
from urdfkit.workspace.gitignore import is_ignored
from urdfkit.workspace.resolve import Resolver

_CONFIG, _MODEL = "model.config", "model.sdf"


def unreadable_models(world: World, models: Models, resolver: Resolver) -> Findings:
    """Models of the workspace in whose only directory Gazebo finds no file to read."""
    for at, uri in world.includes:
        directories = models.directories.get(model_name(uri), [])
        if len({*directories}) != 1:
            continue
        directory = directories[0]
        source = resolver.readable(os.path.join(directory, _CONFIG))
        if source is None:
            names = disk.names_or_empty(directory)
            if _MODEL in names and not {_CONFIG, "manifest.xml"}.intersection(names):
                message = f"model '{uri}' has no {_CONFIG}: the world is not loaded"
                yield Finding(at, message, f"add {_CONFIG}, which names {_MODEL}")
            continue
        document, _ = read_as_tinyxml(source)
        files = document.root.all("sdf") if document else []
        if files and all(_is_missing(file, directory) for file in files):
            yield Finding(
                files[0],
                f"model '{model_name(uri)}': file not found: {files[0].text.strip()}",
                f"write {_MODEL}" if _MODEL in disk.names_or_empty(directory) else "fix the name",
                related=(Related(at.span, "the world includes the model here"),),
            )


def _is_missing(file: Element, directory: str) -> bool:
    """True for a file that is not there, nor made by a build."""
    path = os.path.join(directory, file.text.strip())
    return not disk.exists(path) and not is_ignored(path)
