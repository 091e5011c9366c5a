"""State of the viewer: a robot as last read, with the files that it depends on."""

from __future__ import annotations

import base64
import time
from typing import Any

from urdfkit.core import disk
from urdfkit.core.file_log import FileLog, WatchedFiles
from urdfkit.core.record import Record
from urdfkit.lint.context import Context
from urdfkit.lint.options import Options
from urdfkit.output.report import html
from urdfkit.output.report.document import ReportDocument, ReportInput, describe
from urdfkit.output.report.document import completed as complete
from urdfkit.output.report.scene import PageScene
from urdfkit.output.report.translations import Translator
from urdfkit.output.report.writing import rendered


class ViewerState(Record):
    """The robot as last read."""

    document: ReportDocument  # contents of the page
    drawings: dict[str, str]  # URLs of images, by name
    scene: PageScene | None  # the 3D model; None if it is not available
    declared: dict[str, str]  # arguments declared by the xacro, with their values
    files: WatchedFiles  # all files that the state depends on
    reported: ReportInput  # input of the report
    is_whole: bool = False  # False until the slow results are added

    def message(self, translator: Translator, *, with_scene: bool = True) -> dict[str, Any]:
        """The state as JSON, for a page."""
        message: dict[str, Any] = {
            "content": html.render_content(self.document, translator, self.drawings),
            "files": self.files.count,
            "declared": self.declared,
            "readable": self.document["robot"] is not None,
            "whole": self.is_whole,
        }
        if self.scene is not None and with_scene:
            message["robot"] = self.scene.robot
            message["model"] = base64.b64encode(self.scene.model).decode("ascii")
        return message


def read(file: str, options: Options) -> ViewerState:
    """Read and check a robot.

    Args:
        file: a URDF or xacro file.
        options: of the check.

    Raises:
        UrdfkitError: the file is missing, or cannot be checked.
    """
    log, since = FileLog(), time.time_ns()
    disk.log_to(log)
    try:
        reported = describe(file, options, quick=True)
        document, drawings, scene = rendered(reported, has_images=False)
    finally:
        disk.log_to(None)
    files = WatchedFiles(log, since, listings=False)
    declared = _declared(reported.context)
    return ViewerState(document, drawings, scene, declared, files, reported)


def completed(state: ViewerState) -> ViewerState:
    """The state with statics, collisions and images."""
    if state.document["robot"] is None:
        return state._replace(is_whole=True)
    reported = complete(state.reported)
    document, drawings, _ = rendered(reported, has_images=True)
    return state._replace(document=document, drawings=drawings, reported=reported, is_whole=True)


def _declared(context: Context) -> dict[str, str]:
    """The arguments of a xacro with their given values, or else their defaults as written."""
    xacro = context.reading.xacro
    if xacro is None:
        return {}
    arguments = {name: text for name, text in context.arguments.items() if name in xacro.defaults}
    return xacro.defaults | arguments
