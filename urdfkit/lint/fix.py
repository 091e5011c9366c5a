"""fix(): applies the fixes of findings to the text, round by round, until none is left.

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
from urdfkit.lint.fix_guard import Checker, real_path
from urdfkit.lint.fix_session import Fixes, FixSession
from urdfkit.lint.options import Options, choose, external_codes, words
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
    """Apply the fixes of findings in descriptions of robots and in the files that they include.

    >>> fixes = fix("models/gazebo_pkg/urdf/waking_robot_new.xacro", select=["JNT020"])
    >>> [(one.code, one.span.line) for one in fixes.applied]
    [('JNT020', 203), ('JNT020', 234), ('JNT020', 265)]

    The fix of an info is applied only where ``select`` has its code or name, not just the beginning
    of it. Fixes that overlap are applied one after the other. A fix that adds an error, makes a
    description unreadable, edits what another robot uses and is right about, or leaves its finding
    as it was, is dropped.

    Args:
        files: URDF, xacro or launch files, or directories, as of ``check``.
        unsafe: apply the fixes that may change what the robot does, too.
        force: edit files as well that are generated, read-only or ignored by git, or that lie
            outside the workspace of ``files``.
        generate_meshes: make a mesh for every file of one that is missing, empty or broken. What
            the rules say of the robot with these meshes, a second run reports and fixes.
        arguments: xacro arguments by name.
        packages: directories of ROS packages by name.
        select: rules whose findings are fixed; all if empty.
        ignore: rules whose findings are not.
        targets: names of the programs to check for.
        trust: do not sandbox the expressions of the model.
        config: settings of the project.
        options: the other ones of ``check``.

    Raises:
        UrdfkitError: as of ``check``.
    """
    given = options.given(
        arguments=arguments,
        packages=packages,
        select=words("select", select),
        ignore=words("ignore", ignore),
        targets=words("targets", targets),
        trust=trust,
        config=config,
    )
    fixes = session(files, given, unsafe=unsafe, force=force).run()
    if not generate_meshes:
        return fixes
    texts = {**given.texts, **{file.path: file.after for file in fixes.files}}
    return _with_meshes(fixes, files, given._replace(texts=texts), force=force)


def changes(
    files: Iterable[str | os.PathLike[str]], options: Options, *, unsafe: bool, force: bool
) -> Fixes:
    """What ``fix`` would write, for a diff.

    What is left does not matter where something is fixed: the robots are not checked once more in
    the end, and what slow rules report is missing.

    Args:
        files: as of ``fix``, as the others are.

    Raises:
        UrdfkitError: as of ``check``.
    """
    return session(files, options, unsafe=unsafe, force=force).run(only_files=True)


def session(
    files: Iterable[str | os.PathLike[str]], options: Options, *, unsafe: bool, force: bool
) -> FixSession:
    """The rounds of ``fix``.

    Raises:
        UrdfkitError: as of ``check``.
    """
    resolved = options.resolved()
    codes = {*resolved.select, *choose((), (), options.config, external_codes(options))}
    checker = Checker(files, options._replace(preview=resolved.preview), codes)
    named = rule_index.named(options.select)
    return FixSession(checker, resolved.select, named, unsafe=unsafe, force=force)


def _with_meshes(
    fixes: Fixes, files: Iterable[str | os.PathLike[str]], options: Options, *, force: bool
) -> Fixes:
    """The fixes, with meshes for what is missing or broken.

    Raises:
        UrdfkitError: what makes meshes is not installed.
    """
    meshes, not_generated = _generated_meshes(files, options, force=force)
    replaced = {reference.at.span for one in meshes for reference in one.references}
    places = {(real_path(span.source), *span[1:]) for span in replaced}
    left = tuple(
        one
        for one in fixes.left
        if not rule_index.get(one.diagnostic.code).about_files
        or (real_path(one.diagnostic.span.source), *one.diagnostic.span[1:]) not in places
    )
    return fixes._replace(left=left, meshes=meshes, not_generated=not_generated)


def _generated_meshes(
    files: Iterable[str | os.PathLike[str]], options: Options, *, force: bool
) -> GeneratedMeshes:
    """Meshes for the files of all robots; of a file that several name, that of the last."""
    with needing("generating meshes", "meshes"):
        from urdfkit.robot.assets import placeholder_meshes
    found: dict[str, GeneratedMesh | NotGenerated] = {}
    for robot in filter(None, contexts(options, files)):
        if robot.reading.document is None:
            continue
        ours = Ownership([robot.source.path], robot.resolver)
        generated, not_generated = placeholder_meshes.generate_missing(robot)
        found |= {disk.real(one.path): one for one in not_generated}
        for one in generated:
            may_write = force or ours.owns(one.path)
            found[disk.real(one.path)] = one if may_write else one.not_written(OUTSIDE)
    return placeholder_meshes.GeneratedMeshes.of(list(found.values()))
