"""fix(): applies the fixes of findings to the text, in rounds, until none is left.

A round applies the fixes of a check to the texts in memory and checks again. Files are written
at the end, or not at all.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING

from urdfkit.core import disk
from urdfkit.core.installation import needing
from urdfkit.lint import rule_index
from urdfkit.lint.config import Config
from urdfkit.lint.engine import contexts
from urdfkit.lint.fix_checker import Checker, real_path
from urdfkit.lint.fix_session import Fixes, FixSession
from urdfkit.lint.options import Options, choose, external_codes
from urdfkit.workspace.ownership import OUTSIDE, Ownership

if TYPE_CHECKING:
    from urdfkit.robot.assets.placeholder_meshes import GeneratedMesh, GeneratedMeshes, NotGenerated


def fix(
    *files: str | os.PathLike[str],
    unsafe: bool = False,
    force: bool = False,
    generate_meshes: bool = False,
    arguments: Mapping[str, str] | None = None,
    packages: Mapping[str, str] | None = None,
    select: Iterable[str] = (),
    ignore: Iterable[str] = (),
    targets: Iterable[str] = (),
    trust: bool = False,
    config: Config | None = None,
    options: Options = Options(),
) -> Fixes:
    """Apply the fixes of findings in robot descriptions and in the files that they include.

    >>> fixes = fix("models/gazebo_pkg/urdf/waking_robot_new.xacro", select=["JNT020"])
    >>> [(finding.code, finding.span.line) for finding in fixes.applied]
    [('JNT020', 203), ('JNT020', 234), ('JNT020', 265)]

    The fix of an info is applied only if ``select`` contains its whole code or name, not just a
    prefix. Overlapping fixes are applied in separate rounds. A fix is dropped if it adds an error,
    makes a description unreadable, edits text that another robot uses correctly, or does not
    remove its finding.

    Args:
        files: URDF, xacro or launch files, or directories, see ``check``.
        unsafe: also apply fixes that may change the behaviour of the robot.
        force: also edit files that are generated, read-only, ignored by git, or outside the
            workspace of ``files``.
        generate_meshes: generate a mesh for every mesh file that is missing, empty or broken. A
            second run reports and fixes the findings of the robot with these meshes.
        arguments: xacro arguments by name.
        packages: directories of ROS packages by name.
        select: rules whose findings are fixed; all if empty.
        ignore: rules whose findings are not fixed.
        targets: names of the programs to check for.
        trust: do not sandbox the expressions of the model.
        config: settings of the project.
        options: less common options, see ``check``.

    Raises:
        UrdfkitError: see ``check``.
    """
    options = options.given(
        arguments=arguments,
        packages=packages,
        select=select,
        ignore=ignore,
        targets=targets,
        trust=trust,
        config=config,
    )
    fixes = session(files, options, unsafe=unsafe, force=force).run()
    if not generate_meshes:
        return fixes
    texts = {**options.texts, **{file.path: file.after for file in fixes.files}}
    return _with_meshes(fixes, files, options._replace(texts=texts), force=force)


def changes(
    files: Iterable[str | os.PathLike[str]], options: Options, *, unsafe: bool, force: bool
) -> Fixes:
    """The changes that ``fix`` would write, for a diff.

    If something is fixed, there is no final check of the robots: the remaining findings do not
    contain those of slow rules.

    Args:
        files: see ``fix``, also for the other arguments.

    Raises:
        UrdfkitError: see ``check``.
    """
    return session(files, options, unsafe=unsafe, force=force).run(only_files=True)


def session(
    files: Iterable[str | os.PathLike[str]], options: Options, *, unsafe: bool, force: bool
) -> FixSession:
    """The session that runs the rounds of ``fix``.

    Raises:
        UrdfkitError: see ``check``.
    """
    resolved = options.resolved()
    codes = {*resolved.select, *choose((), (), options.config, external_codes(options))}
    checker = Checker(files, options._replace(preview=resolved.preview), codes)
    named = rule_index.named(options.select)
    return FixSession(checker, resolved.select, named, unsafe=unsafe, force=force)


def _with_meshes(
    fixes: Fixes, files: Iterable[str | os.PathLike[str]], options: Options, *, force: bool
) -> Fixes:
    """The fixes, with generated meshes for missing and broken files.

    Raises:
        UrdfkitError: the libraries that generate meshes are not installed.
    """
    meshes, not_generated = _generated_meshes(files, options, force=force)
    replaced = {reference.at.span for mesh in meshes for reference in mesh.references}
    places = {(real_path(span.source), *span[1:]) for span in replaced}
    left = tuple(
        unapplied
        for unapplied in fixes.left
        if not rule_index.get(unapplied.diagnostic.code).about_files
        or (real_path(unapplied.diagnostic.span.source), *unapplied.diagnostic.span[1:])
        not in places
    )
    return fixes._replace(left=left, meshes=meshes, not_generated=not_generated)


def _generated_meshes(
    files: Iterable[str | os.PathLike[str]], options: Options, *, force: bool
) -> GeneratedMeshes:
    """Meshes for the files of all robots; for a file of several robots, the mesh of the last."""
    with needing("generating meshes", "meshes"):
        from urdfkit.robot.assets import placeholder_meshes
    results: dict[str, GeneratedMesh | NotGenerated] = {}
    for robot in filter(None, contexts(options, files)):
        if robot.reading.document is None:
            continue
        ownership = Ownership([robot.source.path], robot.resolver)
        generated, not_generated = placeholder_meshes.generate_missing(robot)
        results |= {disk.real(failure.path): failure for failure in not_generated}
        for mesh in generated:
            if force or ownership.owns(mesh.path):
                results[disk.real(mesh.path)] = mesh
            else:
                failure = placeholder_meshes.NotGenerated(mesh.path, mesh.defect, OUTSIDE)
                results[disk.real(mesh.path)] = failure
    return placeholder_meshes.GeneratedMeshes.of(list(results.values()))
