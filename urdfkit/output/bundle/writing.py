"""Writes a bundle as a directory or zip file; after an error, nothing is written."""

from __future__ import annotations

import os
import shutil
import zipfile
from collections.abc import Iterable, Iterator
from contextlib import contextmanager

from urdfkit.core import atomic, temporary
from urdfkit.core.record import Record
from urdfkit.core.suggest import did_you_mean
from urdfkit.errors import UnwritableFile, UrdfkitError
from urdfkit.lint.context import Context
from urdfkit.lint.engine import check
from urdfkit.lint.loading import read
from urdfkit.lint.options import Options
from urdfkit.lint.rules import Need
from urdfkit.output.bundle import MANIFEST, Bundle, bundled_meshes, located_files
from urdfkit.output.bundle.consumers import CONSUMERS, Consumer
from urdfkit.output.bundle.meshes import BundledFile, FreeNames
from urdfkit.text.diagnostic import Severity
from urdfkit.text.source import Span, shown

#: Needs of slow rules, which never report why a program rejects a robot.
_SLOW = frozenset((Need.COLLISIONS,))

#: Date of all files in a zip, so that equal bundles have equal bytes.
_DATE = (1980, 1, 1, 0, 0, 0)


class TargetError(Record):
    """The reason why a program rejects a bundle."""

    code: str  # of the rule
    message: str
    span: Span  # location in the original source, else in the URDF of the bundle


def bundle(
    robot: Context | str | os.PathLike[str],
    out: str | os.PathLike[str],
    *,
    consumer: str = "any",
    force: bool = False,
) -> tuple[Bundle, tuple[TargetError, ...]]:
    """Write a robot with all referenced files, for another machine or program.

    Args:
        robot: a URDF or xacro file, or the result of `urdfkit.read`.
        out: a directory, or a file that ends in ``.zip``; after an error, nothing is written.
        consumer: a name of `CONSUMERS`; meshes that this program cannot read are converted.
        force: replace an existing bundle.

    Returns:
        The bundle, and the reasons why the program rejects it.

    Raises:
        UrdfkitError: the consumer is unknown; the file is a part of a robot; a file is missing,
            broken, or cannot be written.
    """
    if consumer not in CONSUMERS:
        raise UrdfkitError(f"no program '{consumer}'{did_you_mean(consumer, CONSUMERS)}")
    context = robot if isinstance(robot, Context) else read(robot)
    result = Bundle(context, CONSUMERS[consumer])
    with staged(result.files(), os.path.abspath(out), force=force) as directory:
        target = CONSUMERS[consumer].target or consumer
        rejected = tuple(_errors(result, directory, context, target))
    return result, rejected


def _errors(result: Bundle, directory: str, context: Context, target: str) -> Iterator[TargetError]:
    places = {element.path: element.span for element in context.document.root.walk()}
    path = os.path.join(directory, result.urdf)
    if read(path).is_part:
        raise UrdfkitError(
            f"{shown(context.source.path)}: is only a part of a robot; bundle the file that "
            "includes it"
        )
    # DYN001 repeats what other rules report, if Pinocchio is installed.
    options = Options(targets=(target,), only_errors=_SLOW, ignore=("DYN001",))
    report = check(path, options=options)
    for diagnostic in report.diagnostics:
        if diagnostic.severity is Severity.ERROR:
            span = places.get(diagnostic.element.partition("@")[0], diagnostic.span)
            yield TargetError(diagnostic.code, diagnostic.message, span)


@contextmanager
def staged(
    files: Iterable[BundledFile], out: str, *, force: bool, mark: str = MANIFEST
) -> Iterator[str]:
    """A new directory with the files of a bundle, which is renamed to ``out`` at the end.

    The directory is removed after an error.

    Args:
        out: a directory, or a file that ends in ``.zip``.
        force: replace an existing bundle.
        mark: the file that marks such a directory.

    Raises:
        UnwritableFile: ``out`` exists, or cannot be written.
    """
    atomic.make_directory(os.path.dirname(out))
    with _as_unwritable(out), temporary.workshop(out) as workshop:
        new, old = os.path.join(workshop, "bundle"), os.path.join(workshop, "old")
        _put_back(old, out)  # left by a killed process
        _empty(workshop)
        _require_free(out, mark, force=force)
        write_files(files, new)
        yield new
        try:
            if _is_zip(out):
                new = _zipped(new, os.path.join(workshop, "bundle.zip"))
            elif os.path.isdir(out):
                os.replace(out, old)
            os.replace(new, out)
        finally:
            _put_back(old, out)


def _put_back(old: str, out: str) -> None:
    """Restore a directory or file that was not replaced."""
    if os.path.isdir(old) and not os.path.lexists(out):
        os.replace(old, out)


def _empty(directory: str) -> None:
    for entry in list(os.scandir(directory)):
        if entry.is_dir(follow_symlinks=False):
            shutil.rmtree(entry.path)
        else:
            os.unlink(entry.path)


@contextmanager
def _as_unwritable(out: str) -> Iterator[None]:
    try:
        yield
    except BlockingIOError as error:
        raise UnwritableFile(f"{out}: cannot be written: another process is writing it") from error
    except OSError as error:
        raise UnwritableFile(f"{out}: cannot be written: {error.strerror or error}") from error


def _is_zip(out: str) -> bool:
    return out.lower().endswith(".zip")


def _require_free(out: str, mark: str, *, force: bool) -> None:
    if not os.path.lexists(out) or (os.path.isdir(out) and not os.listdir(out)):
        return
    is_file = not os.path.isdir(out)
    if is_file and not _is_zip(out):
        raise UnwritableFile(f"{out}: is a file; pass a directory, or a name that ends in .zip")
    if is_file != _is_zip(out) or os.path.islink(out) or not _contains(out, mark):
        kind = "file" if is_file else "directory"
        raise UnwritableFile(f"{out}: is a {kind} without {mark}; pass another path")
    if not force:
        raise UnwritableFile(f"{out}: exists; --force replaces it")


def _contains(out: str, file: str) -> bool:
    """True if a directory or zip contains a file."""
    if not os.path.isfile(out):  # opening a pipe would wait for a writer
        return os.path.isfile(os.path.join(out, file))
    try:
        with zipfile.ZipFile(out) as archive:
            return file in archive.namelist()
    except (OSError, ValueError, NotImplementedError, zipfile.BadZipFile):
        return False


def write_files(files: Iterable[BundledFile], directory: str) -> None:
    for file in files:
        path = os.path.join(directory, *file.path.split("/"))
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "xb") as target:
            target.write(file.data)


def write_collisions(robot: Context, consumer: Consumer, directory: str) -> dict[int, str]:
    """Write the collision meshes as in a bundle.

    Returns:
        Their paths in the directory, by ``id`` of the reference.

    Raises:
        UrdfkitError: a mesh is missing, broken, or cannot be converted to a supported format.
    """
    references = [body.file for body in robot.model.collisions if body.file]
    paths = located_files(robot, references)
    names: dict[str, str] = {}
    meshes = bundled_meshes(robot, references, paths, names, consumer, FreeNames(), frozenset())
    write_files(meshes, directory)
    return {key: names[path] for key, path in paths.items()}


def _zipped(directory: str, path: str) -> str:
    """Write a directory as a zip, whose bytes depend only on its files."""
    with zipfile.ZipFile(path, "x", zipfile.ZIP_DEFLATED) as archive:
        for at, _, names in sorted(os.walk(directory)):
            for name in sorted(names):
                file = os.path.join(at, name)
                entry = zipfile.ZipInfo(
                    os.path.relpath(file, directory).replace(os.sep, "/"), _DATE
                )
                entry.external_attr = 0o644 << 16
                with open(file, "rb") as source, archive.open(entry, "w") as target:
                    shutil.copyfileobj(source, target)
    return path
