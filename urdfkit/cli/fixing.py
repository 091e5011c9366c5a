"""Fixes of a parsed command line, for ``urdfkit fix`` and ``urdfkit check --fix``."""

from collections import Counter
from collections.abc import Iterator, Mapping
from typing import Any

from urdfkit.cli import options, output
from urdfkit.cli.progress import progress_of_files
from urdfkit.core.words import counted
from urdfkit.lint.fix import changes, fix
from urdfkit.lint.fix_session import Fixes
from urdfkit.lint.options import Options
from urdfkit.text.source import shown
from urdfkit.text.terminal import printable


def apply_fixes(
    values: Mapping[str, Any], settings: Options, *, generate_meshes: bool = False
) -> Fixes:
    """Fix the files in place, print the changes as a diff (--diff), or only find them (--check)."""
    files = options.files(values)
    if "-" in files:
        raise options.UsageError("standard input cannot be fixed in place; pass a file")
    unsafe, force = values["unsafe_fixes"], values["force"]
    with progress_of_files(files) as progress:
        settings = settings._replace(progress=progress)
        if values["diff"] and not generate_meshes:
            fixes = changes(files, settings, unsafe=unsafe, force=force)
        else:
            fixes = fix(
                *files,
                unsafe=unsafe,
                force=force,
                generate_meshes=generate_meshes,
                options=settings,
            )
        if values["diff"]:
            output.write_diff(fixes.diff())
            return fixes
        if values.get("check"):
            return fixes
        fixes.write()
        if not fixes.meshes:
            return fixes
        # The generated meshes may lead to further findings and fixes.
        again = fix(*files, unsafe=unsafe, force=force, options=settings)
        again.write()
    first = {file.path: file for file in fixes.files}
    return again._replace(
        files=tuple({**{file.path: file for file in again.files}, **first}.values()),
        applied=(*fixes.applied, *again.applied),
        meshes=fixes.meshes,
        not_generated=fixes.not_generated,
    )


def print_fixes(fixes: Fixes) -> None:
    """Print the fixed files and the reasons for unapplied fixes to standard error."""
    output.log(*(f"fixed {shown(file.path)}" for file in fixes.files))
    reasons = {left.reason for left in fixes.left} - {"", "unsafe", "info"}
    for reason in sorted(reasons):
        count = sum(left.reason == reason for left in fixes.left)
        output.log(f"not fixed ({count}): {reason}")


def print_no_fixes(fixes: Fixes) -> None:
    """Print to standard error why a diff is empty."""
    output.log(total(fixes, "would be fixed"), *_reasons(fixes))


def total(fixes: Fixes, verb: str) -> str:
    """The numbers of fixes and of findings that are left."""
    unsafe = sum(left.reason == "unsafe" for left in fixes.left)
    text = f"{len(fixes.applied)} {verb} in {counted(len(fixes.files), 'file')}, "
    text += f"{len(fixes.left)} left"
    return text + (f", {unsafe} of them with an unsafe fix (--unsafe-fixes)" if unsafe else "")


def _reasons(fixes: Fixes) -> Iterator[str]:
    """The reasons for fixes that no other option applies, with their number."""
    reasons = Counter(left.reason for left in fixes.left if left.diagnostic.fix)
    for reason, count in reasons.items():
        if reason not in ("", "info", "unsafe"):
            yield f"not fixable: {count} ({printable(reason)})"
