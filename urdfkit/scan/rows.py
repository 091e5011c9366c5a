"""Rows of a scan: one for each model, and one for each finding."""

from __future__ import annotations

import hashlib
import os
import time
from collections.abc import Iterable
from functools import lru_cache

from urdfkit.core import limits
from urdfkit.core.record import Record
from urdfkit.errors import NotEnoughMemory, Unavailable, UrdfkitError
from urdfkit.lint.context import Context
from urdfkit.lint.engine import check_robots
from urdfkit.lint.options import Options
from urdfkit.robot.kinematics import frames
from urdfkit.robot.shapes import primitive
from urdfkit.scan.models import Model
from urdfkit.text.diagnostic import Diagnostic, Severity
from urdfkit.text.source import shown, without_directory
from urdfkit.workspace.resolve import Resolver


class FindingRow(Record):
    """A finding."""

    #: code and rule: of the rule, such as ``MSH001`` and ``missing-file``.
    code: str
    rule: str
    severity: str  # ``error``, ``warning`` or ``info``
    message: str  # one sentence
    path: str  # of the file; for a member of an archive, below the path of the archive
    #: line and column: from 1.
    line: int
    column: int
    element: str  # path of the element after expansion
    places: int  # number of macro expansions with the finding


class ModelRow(Record):
    """A model."""

    model: str  # name in the scan
    #: ``ok``, ``unreadable`` (no file, not XML, does not expand, a damaged archive), ``crashed`` (a
    #: bug in urdfkit), ``timeout``, ``memory``, or ``died`` (its process was killed).
    status: str
    reason: str = ""  # why the status is not ``ok``
    hash: str = ""  # SHA-256 of the expanded description and its mesh files
    robot: str = ""  # name of the robot
    #: links, joints, dof, visuals, collisions: counts.
    links: int | None = None
    joints: int | None = None
    dof: int | None = None
    visuals: int | None = None
    collisions: int | None = None
    #: meshes and missing: existing mesh files, and references to missing ones.
    meshes: int | None = None
    missing: int | None = None
    mass: float | None = None  # of all links, in kg
    #: size_x, size_y, size_z: of the bounding box of all shapes in the zero configuration, in m;
    #: None without shapes.
    size_x: float | None = None
    size_y: float | None = None
    size_z: float | None = None
    #: errors, warnings, infos: numbers of findings.
    errors: int = 0
    warnings: int = 0
    infos: int = 0
    seconds: float = 0.0  # of the check
    cpu_seconds: float = 0.0  # processor time of the check
    findings: tuple[FindingRow, ...] = ()


def check_model(model: Model, options: Options, resolver: Resolver) -> ModelRow:
    """Check a model and measure it.

    Args:
        options: resolved.
        resolver: shared by all models; caches packages and directories.
    """
    start, start_cpu = time.perf_counter(), time.process_time()
    row = _row(model, options, resolver)
    return row._replace(
        seconds=round(time.perf_counter() - start, 4),
        cpu_seconds=round(time.process_time() - start_cpu, 4),
    )


def _row(model: Model, options: Options, resolver: Resolver) -> ModelRow:
    if model.problem:
        return ModelRow(model.name, "unreadable", model.problem)
    try:
        report, contexts = check_robots(options, model.path, resolver)
        robots = [context for context in contexts if not context.is_bringup]
        row = _measured(model, robots[0]) if robots else ModelRow(model.name, "ok")
    except UrdfkitError as error:
        status = "memory" if isinstance(error, NotEnoughMemory) else "unreadable"
        return ModelRow(model.name, status, _portable(str(error), model))
    except Exception as error:
        status = "memory" if limits.lacks_memory(error) else "crashed"
        return ModelRow(model.name, status, f"{type(error).__name__}: {error}")
    if report.crashed:
        reason = f"{report.crashed[0].code} {report.crashed[0].error}".strip()
        row = row._replace(status="crashed", reason=reason)
    return row._replace(
        errors=report.count(Severity.ERROR),
        warnings=report.count(Severity.WARNING),
        infos=report.count(Severity.INFO),
        findings=tuple(_finding(diagnostic, model) for diagnostic in report.diagnostics),
    )


def _measured(model: Model, context: Context) -> ModelRow:
    """The measured values of a robot; for an unreadable one, the reason."""
    try:
        text, robot = context.text, context.model
    except Unavailable as reason:
        digest = hashlib.sha256(context.source.data).hexdigest()
        return ModelRow(model.name, "unreadable", str(reason), digest)
    x, y, z = _size(context)
    return ModelRow(
        model.name,
        "ok",
        hash=_digest(text, context.files.paths),
        robot=robot.name,
        links=len(robot.links),
        joints=len(robot.joints),
        dof=robot.degrees_of_freedom,
        visuals=sum(len(link.visuals) for link in robot.links),
        collisions=sum(len(link.collisions) for link in robot.links),
        meshes=len(context.files.paths),
        missing=sum(mesh.located.path is None for mesh in context.files.meshes),
        mass=robot.mass,
        size_x=x,
        size_y=y,
        size_z=z,
    )


def _size(context: Context) -> tuple[float | None, float | None, float | None]:
    """The edges of the bounding box of all shapes in the zero configuration, along the root's axes.

    Meshes are represented by their cached measures, so that no triangle is read.
    """
    low, high = [float("inf")] * 3, [float("-inf")] * 3
    for name, frame in frames(context.tree, {}).items():
        link = context.model.links_by_name[name]
        for body in link.bodies:
            part = primitive(body) or context.mesh_solid(body)
            if part is None:
                continue
            for axis, row in enumerate(frame.rotation):
                x, y, z = row
                at = frame.position[axis]
                low[axis] = min(low[axis], at - part.reach((-x, -y, -z)))
                high[axis] = max(high[axis], at + part.reach(row))
    if low[0] > high[0]:
        return None, None, None
    x, y, z = (round(b - a, 9) for a, b in zip(low, high, strict=True))
    return x, y, z


def _digest(text: bytes, files: Iterable[str]) -> str:
    digest = hashlib.sha256(text)
    for path in files:
        try:
            status = os.stat(path)
            digest.update(_file_digest(path, status.st_mtime_ns, status.st_size))
        except OSError:
            digest.update(b"unreadable")
    return digest.hexdigest()


@lru_cache(maxsize=4096)
def _file_digest(path: str, modified: int, size: int) -> bytes:
    """Hash of a mesh file; models of a collection may share the file."""
    digest = hashlib.sha256()
    with open(path, "rb") as file:
        while block := file.read(1 << 20):
            digest.update(block)
    return digest.digest()


def _finding(diagnostic: Diagnostic, model: Model) -> FindingRow:
    return FindingRow(
        diagnostic.code,
        diagnostic.name,
        diagnostic.severity.value,
        _portable(diagnostic.message, model),
        _portable(shown(diagnostic.span.source.path), model),
        diagnostic.span.line,
        diagnostic.span.column,
        diagnostic.element,
        len(diagnostic.calls),
    )


def _portable(text: str, model: Model) -> str:
    """A text with the path of the archive instead of the directory it was extracted to."""
    if not model.directory:
        return text
    return without_directory(text, model.directory, f"{model.archive}/")
