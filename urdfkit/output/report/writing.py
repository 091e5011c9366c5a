"""report(): the report of a robot in the format of a file's suffix."""

from __future__ import annotations

import os

from urdfkit.core.progress import Progress
from urdfkit.core.record import Record
from urdfkit.core.strict_json import dumped
from urdfkit.errors import Unavailable, UrdfkitError
from urdfkit.lint.options import Options
from urdfkit.output.report.document import LONG, ReportDocument, ReportInput, describe
from urdfkit.output.report.scene import PageScene
from urdfkit.output.report.translations import Translator
from urdfkit.text.source import Source

#: Forms of a report, by the suffix of a file.
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
    """The text of a report, and the document that it was made from.

    Args:
        file: a URDF or xacro file.
        form: ``html``, ``markdown``, ``json`` or ``csv``.
        options: of the check.
        language: of headings and the like: ``en`` or ``zh``.
        table: of CSV, one of `csv.COLUMNS`.
        quick: leave out what takes a while: images, statics and collisions.
        progress: called with the number of steps done and of all, where it takes a while.

    Raises:
        UnreadableFile: the file is missing or may not be read.
        UrdfkitError: the form needs a library that is not installed, or has no such table.
    """
    is_quick = quick or not _shows_all(form, table)
    reported = describe(file, options, quick=is_quick, progress=progress)
    document = reported.document
    if form == "json":
        return dumped(document), document
    if form == "csv":
        from urdfkit.output.report import csv

        return csv.render(document, table), document
    if form == "markdown":
        from urdfkit.output.report import markdown

        return markdown.render(document, Translator(language)), document
    return _page(reported, Translator(language), has_images=not quick)


def _shows_all(form: str, table: str) -> bool:
    """True if a form shows what takes a while."""
    return form in ("html", "json") or (form == "csv" and table in LONG)


def _page(
    reported: ReportInput, translator: Translator, *, has_images: bool
) -> tuple[str, ReportDocument]:
    """A page with images and the 3D view, if they can be had; else with the reason why not."""
    from urdfkit.output.report import html

    document, data_uris, scene = rendered(reported, has_images=has_images)
    if scene is None:
        return html.render(document, translator, data_uris), document
    from urdfkit.output.report import engine

    return html.render(document, translator, data_uris, scene, engine.load()), document


class RobotImages(Record):
    """A robot as images."""

    document: ReportDocument  # its contents, and why an image is missing
    drawings: dict[str, str]  # addresses of images, by name
    scene: PageScene | None  # the robot in three dimensions; None if it cannot be had


def rendered(reported: ReportInput, *, has_images: bool) -> RobotImages:
    """Drawings of a robot, and the robot in three dimensions; what cannot be had is left out."""
    from urdfkit.output.report import data_uris, scene

    context = reported.context
    found = data_uris.tree(context)
    if context.reading.document is None or not context.model.links:
        return RobotImages(reported.document, found, None)
    try:
        built = scene.surfaces(context)
    except Unavailable as error:
        return RobotImages(_without_view(reported.document, str(error)), found, None)
    if has_images:
        found |= data_uris.images(built, context, reported.diagnostics)
    document, triangles = reported.document, sum(len(item.faces) for item in built.items)
    if triangles > scene.MAX_TRIANGLES:
        reason = f"simplified: the robot has {triangles} triangles: see urdfkit mesh simplify"
        document = _without_view(document, reason)
    return RobotImages(document, found, scene.build(context, built))


def _without_view(document: ReportDocument, reason: str) -> ReportDocument:
    """The document, with the reason why the 3D view is missing or incomplete."""
    return {**document, "missing": {**document["missing"], "3D view": reason}}


def form_of(target: str) -> str:
    """The format of the suffix of a file.

    Raises:
        UrdfkitError: it has none.
    """
    for suffix, form in SUFFIXES.items():
        if target.lower().endswith(suffix):
            return form
    raise UrdfkitError(f"{target}: the suffix is not one of {', '.join(SUFFIXES)}")
