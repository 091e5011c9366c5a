"""What the viewer shows at a moment, and the files that it was made from."""

from __future__ import annotations

import base64
import os
from collections.abc import Iterable
from typing import Any

from urdfkit.core.record import Record
from urdfkit.lint.context import Context
from urdfkit.lint.options import Options
from urdfkit.output.report import html
from urdfkit.output.report.document import ReportDocument, ReportInput, describe
from urdfkit.output.report.document import completed as complete
from urdfkit.output.report.scene import PageScene
from urdfkit.output.report.translations import Translator
from urdfkit.output.report.writing import rendered
from urdfkit.text.diagnostic import Diagnostic

#: The size and the time of change of a file; None if it is not there.
FileVersion = tuple[int, int] | None


class ViewerState(Record):
    """One state of the robot, as it was last read."""

    document: ReportDocument  # its contents
    drawings: dict[str, str]  # addresses of images, by name
    scene: PageScene | None  # the robot in three dimensions; None if it cannot be had
    declared: dict[str, str]  # the arguments that the xacro declares, each with its value
    versions: dict[str, FileVersion]  # of every file that it was made from
    reported: ReportInput  # what it was made of
    is_whole: bool = False  # False while that which takes a while is not there yet

    def message(self, translator: Translator, *, with_scene: bool = True) -> dict[str, Any]:
        """What a page needs to show it; JSON can hold it."""
        found: dict[str, Any] = {
            "content": html.render_content(self.document, translator, self.drawings),
            "files": len(self.versions),
            "declared": self.declared,
            "readable": self.document["robot"] is not None,
            "whole": self.is_whole,
        }
        if self.scene is not None and with_scene:
            found["robot"] = self.scene.robot
            found["model"] = base64.b64encode(self.scene.model).decode("ascii")
        return found

    @property
    def is_stale(self) -> bool:
        """True if one of its files has changed, come or gone."""
        return any(file_version(path) != known for path, known in self.versions.items())


def read(file: str, options: Options, known: Iterable[str] = ()) -> ViewerState:
    """Read and check a robot.

    Args:
        file: a URDF or xacro file.
        options: of the check.
        known: the files that it was made from before. One of them that changes while it is read
            makes the state stale at once.

    Raises:
        UrdfkitError: the file is missing, or the job cannot be done.
    """
    before = {path: file_version(path) for path in (file, *known)}
    reported = describe(file, options, quick=True)
    context = reported.context
    document, drawings, scene = rendered(reported, has_images=False)
    files = files_of(context, reported.diagnostics) | {file}
    if scene is not None:
        files |= _images(context)
    versions = {path: before[path] if path in before else file_version(path) for path in files}
    return ViewerState(document, drawings, scene, _declared(context), versions, reported)


def completed(state: ViewerState) -> ViewerState:
    """The same with statics, collisions and images."""
    if state.document["robot"] is None:
        return state._replace(is_whole=True)
    reported = complete(state.reported)
    document, drawings, _ = rendered(reported, has_images=True)
    return state._replace(document=document, drawings=drawings, reported=reported, is_whole=True)


def files_of(context: Context, diagnostics: Iterable[Diagnostic]) -> set[str]:
    """Every file that a robot is made from, those included that are missing."""
    found = {context.source.path}
    xacro = context.reading.xacro
    if xacro is not None:
        found |= {source.path for source in xacro.sources} | set(xacro.data_files)
    if context.reading.document is not None:
        for mesh in context.files.meshes:
            at = mesh.located
            found.add(at.path or os.path.join(at.directory or os.curdir, at.relative))
    return found | {one.span.source.path for one in diagnostics}


def _images(context: Context) -> set[str]:
    """The files that the appearance of a robot needs besides its meshes, such as images."""
    found: set[str] = set()
    for body in (body for link in context.model.links for body in link.visuals):
        if body.material and body.material.texture is not None:
            found.add(context.files.find(body.material.texture) or "")
        mesh = context.meshes.mesh(body.shape) if body.shape and body.shape.kind == "mesh" else None
        found.update(mesh.files if mesh else ())
    return found - {""}


def _declared(context: Context) -> dict[str, str]:
    """The arguments of a xacro, each with the value that was given, or its default as written."""
    xacro = context.reading.xacro
    if xacro is None:
        return {}
    given = {name: text for name, text in context.arguments.items() if name in xacro.defaults}
    return xacro.defaults | given


def file_version(path: str) -> FileVersion:
    """The state of a file; None if it is not there."""
    try:
        status = os.stat(path)
    except (OSError, ValueError):
        return None
    return status.st_size, status.st_mtime_ns
