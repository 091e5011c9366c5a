"""State of the viewer: a robot as last read, with the files that it depends on."""

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

#: Size and modification time of a file; None if it is missing.
FileVersion = tuple[int, int] | None


class ViewerState(Record):
    """The robot as last read."""

    document: ReportDocument  # contents of the page
    drawings: dict[str, str]  # URLs of images, by name
    scene: PageScene | None  # the 3D model; None if it is not available
    declared: dict[str, str]  # arguments declared by the xacro, with their values
    versions: dict[str, FileVersion]  # of all files that the state depends on
    reported: ReportInput  # input of the report
    is_whole: bool = False  # False until the slow results are added

    def message(self, translator: Translator, *, with_scene: bool = True) -> dict[str, Any]:
        """The state as JSON, for a page."""
        message: dict[str, Any] = {
            "content": html.render_content(self.document, translator, self.drawings),
            "files": len(self.versions),
            "declared": self.declared,
            "readable": self.document["robot"] is not None,
            "whole": self.is_whole,
        }
        if self.scene is not None and with_scene:
            message["robot"] = self.scene.robot
            message["model"] = base64.b64encode(self.scene.model).decode("ascii")
        return message

    @property
    def is_stale(self) -> bool:
        """True if a file has changed, appeared or disappeared."""
        return any(file_version(path) != version for path, version in self.versions.items())


def read(file: str, options: Options, known: Iterable[str] = ()) -> ViewerState:
    """Read and check a robot.

    Args:
        file: a URDF or xacro file.
        options: of the check.
        known: the files of the previous state. If one of them changes during the read, the new
            state is stale immediately.

    Raises:
        UrdfkitError: the file is missing, or cannot be checked.
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
    """The state with statics, collisions and images."""
    if state.document["robot"] is None:
        return state._replace(is_whole=True)
    reported = complete(state.reported)
    document, drawings, _ = rendered(reported, has_images=True)
    return state._replace(document=document, drawings=drawings, reported=reported, is_whole=True)


def files_of(context: Context, diagnostics: Iterable[Diagnostic]) -> set[str]:
    """All files that a robot depends on, including missing ones."""
    files = {context.source.path}
    xacro = context.reading.xacro
    if xacro is not None:
        files |= {source.path for source in xacro.sources} | set(xacro.data_files)
    if context.reading.document is not None:
        for mesh in context.files.meshes:
            at = mesh.located
            files.add(at.path or os.path.join(at.directory or os.curdir, at.relative))
    return files | {diagnostic.span.source.path for diagnostic in diagnostics}


def _images(context: Context) -> set[str]:
    """The files of a robot's appearance other than its meshes, such as textures."""
    images: set[str] = set()
    for body in context.model.visuals:
        if body.material and body.material.texture is not None:
            images.add(context.files.find(body.material.texture) or "")
        mesh = context.meshes.mesh(body.shape) if body.shape and body.is_mesh else None
        images.update(mesh.files if mesh else ())
    return images - {""}


def _declared(context: Context) -> dict[str, str]:
    """The arguments of a xacro with their given values, or else their defaults as written."""
    xacro = context.reading.xacro
    if xacro is None:
        return {}
    arguments = {name: text for name, text in context.arguments.items() if name in xacro.defaults}
    return xacro.defaults | arguments


def file_version(path: str) -> FileVersion:
    """The version of a file; None if it is missing."""
    try:
        status = os.stat(path)
    except (OSError, ValueError):
        return None
    return status.st_size, status.st_mtime_ns
