"""The `report` function: the report of a robot in a format."""

from __future__ import annotations

import os
from collections.abc import Mapping

from urdfkit.core.progress import Progress
from urdfkit.core.record import Record
from urdfkit.core.strict_json import dumped
from urdfkit.errors import Unavailable, UrdfkitError
from urdfkit.lint.options import Options
from urdfkit.output.report.document import SLOW_SECTIONS, ReportDocument, ReportInput, describe
from urdfkit.output.report.scene import PageScene
from urdfkit.output.report.translations import Translator
from urdfkit.text.source import Source

#: Formats of a report, by file suffix.
SUFFIXES = {".html": "html", ".htm": "html", ".md": "markdown", ".json": "json", ".csv": "csv"}


def report(
    file: str | os.PathLike[str] | Source,
    form: str = "html",
    options: Options = Options(),
    *,
    language: str = "en",
    table: str = "findings",
    quick: bool = False,
    progress: Progress | None = None,
) -> tuple[str, ReportDocument]:
    """The text of a report, and its document.

    Args:
        file: a URDF or xacro file.
        form: ``html``, ``markdown``, ``json`` or ``csv``.
        options: of the check.
        language: of headings and the like: ``en`` or ``zh``.
        table: of CSV, one of `csv.COLUMNS`.
        quick: omit the slow parts: images, statics, stability and collisions.
        progress: called with the number of finished steps and of all steps of a slow part.

    Raises:
        UnreadableFile: the file is missing or cannot be read.
        UrdfkitError: the format needs a library that is not installed, or lacks the table.
    """
    shows_all = form in ("html", "json") or (form == "csv" and table in SLOW_SECTIONS)
    reported = describe(file, options, quick=quick or not shows_all, progress=progress)
    document = reported.document
    if form == "json":
        return dumped(document), document
    if form == "csv":
        from urdfkit.output.report import csv

        return csv.render(document, table), document
    if form == "markdown":
        from urdfkit.output.report import markdown

        return markdown.render(document, Translator(language)), document
    from urdfkit.output.report import engine, html

    document, data_uris, scene = rendered(reported, has_images=not quick)
    in_3d = engine.load() if scene else None
    return html.render(document, Translator(language), data_uris, scene, in_3d), document


class RobotImages(Record):
    """Images of a robot."""

    document: ReportDocument  # of the report, with the reason if an image is missing
    drawings: dict[str, str]  # URIs of images, by name
    scene: PageScene | None  # the robot in 3D; None if it is unavailable


def rendered(reported: ReportInput, *, has_images: bool) -> RobotImages:
    """Drawings of a robot, and the robot in 3D; unavailable images are omitted."""
    from urdfkit.output.report import data_uris, scene

    context = reported.context
    drawings = data_uris.tree(context)
    if context.reading.document is None or not context.model.links:
        return RobotImages(reported.document, drawings, None)
    try:
        built = scene.surfaces(context)
    except Unavailable as error:
        return RobotImages(_without_view(reported.document, str(error)), drawings, None)
    if has_images:
        drawings |= data_uris.images(built, context, reported.diagnostics)
    document, triangles = reported.document, sum(len(item.faces) for item in built.items)
    if triangles > scene.MAX_TRIANGLES:
        reason = f"simplified: the robot has {triangles} triangles: see urdfkit mesh simplify"
        document = _without_view(document, reason)
    return RobotImages(document, drawings, scene.build(context, built))


def _without_view(document: ReportDocument, reason: str) -> ReportDocument:
    """The document, with the reason why the 3D view is missing or incomplete."""
    return {**document, "missing": {**document["missing"], "3D view": reason}}


def form_of(target: str, suffixes: Mapping[str, str] = SUFFIXES) -> str:
    """The format of a file name.

    Args:
        suffixes: the formats by suffix.

    Raises:
        UrdfkitError: the suffix is unknown.
    """
    for suffix, form in suffixes.items():
        if target.lower().endswith(suffix):
            return form
    raise UrdfkitError(f"{target}: the suffix is not one of {', '.join(suffixes)}")
