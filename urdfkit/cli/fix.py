"""``urdfkit fix``: apply fixes, and report what was fixed, what is left, and why."""

from collections.abc import Iterable, Iterator
from typing import Any

import click

from urdfkit.cli import options, output
from urdfkit.cli.checking import check_settings, fail_on
from urdfkit.cli.decorators import click_option, described, option
from urdfkit.cli.fixing import apply_fixes, print_no_fixes, total
from urdfkit.core.words import few
from urdfkit.lint.fix_session import Fixes
from urdfkit.text.diagnostic import Diagnostic
from urdfkit.text.source import shown
from urdfkit.text.terminal import printable, wrap

_OPTIONS = (
    "quiet unsafe-fixes diff force select ignore rules preview min-confidence target "
    "package trust xacro-seconds xacro-megabytes changed jobs no-cache config isolated variant"
).split()
#: Most line numbers that are listed for one kind of finding.
_MAX_LINES = 8


@described("fix")
@click.argument(options.FILES, nargs=-1, metavar="FILE... [NAME:=VALUE]...")
@option("--generate-meshes", "Generate meshes for files that are missing, empty or broken.")
@option("--check", "Write nothing; exit with 1 if a file would change.")
@option(
    "--fail-on SEVERITY",
    "Exit with 1 if findings of this severity or above are left.",
    type=click.Choice(["error", "warning", "info"]),
)
def command(**values: Any) -> int:
    """Apply auto-fixes to source files; keep layout and comments.

    FILE is a URDF or xacro file, or a directory of them. Comments, quotes, indentation and line
    ends are kept; files are written atomically. Without --unsafe-fixes, only fixes that cannot
    change the behaviour of the robot are applied. Fixes of infos are applied only with
    --select CODE.

    Exit codes: 0 done, even if findings are left; 1 a file would change (--check, --diff), or
    findings at or above --fail-on are left, if it is given; 2 usage or input error;
    3 internal error (a bug in urdfkit).

    Examples:
        urdfkit fix . --unsafe-fixes --diff
        urdfkit fix robot.urdf.xacro --select INE,URD --unsafe-fixes
    """
    settings = check_settings(values)
    fixes = apply_fixes(values, settings, generate_meshes=values["generate_meshes"])
    if values["diff"]:
        output.write("".join(f"# {line}\n" for line in _meshes(fixes, "would generate")))
        if not fixes.files and not values["quiet"]:
            print_no_fixes(fixes)
        return int(bool(fixes.files or fixes.meshes))
    is_dry = values["check"]
    lines = _left(fixes) if values["quiet"] else render(fixes, is_dry=is_dry)
    output.write("".join(f"{line}\n" for line in lines))
    if fixes.report.crashed:
        return 3
    if values["fail_on"]:
        return fixes.report.exit_code(fail_on(values, settings))
    return int(is_dry and bool(fixes.files or fixes.meshes))


command.params += (click_option(each) for each in options.CHECK if each.flag[2:] in _OPTIONS)


def render(fixes: Fixes, *, is_dry: bool = False) -> Iterator[str]:
    yield from _applied(fixes, "would fix" if is_dry else "fixed")
    meshes = list(_meshes(fixes, "would generate" if is_dry else "generated"))
    yield from (*meshes, "") if meshes else ()
    yield from _left(fixes)
    yield total(fixes, "would be fixed" if is_dry else "fixed")


def _applied(fixes: Fixes, verb: str) -> Iterator[str]:
    groups: dict[str, dict[tuple[str, str], list[Diagnostic]]] = {}
    for fixed in fixes.applied:
        assert fixed.fix is not None
        path = shown(fixed.fix.edits[0].span.source.path)
        groups.setdefault(path, {}).setdefault((fixed.code, fixed.fix.title), []).append(fixed)
    for path, kinds in sorted(groups.items()):
        yield f"{verb} in {printable(path)}:"
        for (code, title), diagnostics in kinds.items():
            yield _row(f"{code}  {printable(title)}", diagnostics)
        yield ""


def _meshes(fixes: Fixes, verb: str) -> Iterator[str]:
    for mesh in fixes.meshes:
        yield f"{verb} {printable(shown(mesh.path))}:"
        yield from output.indented(mesh.reason)
    for failure in fixes.not_generated:
        yield f"cannot generate {printable(shown(failure.path))}:"
        yield from output.indented(failure.reason)


def _left(fixes: Fixes) -> Iterator[str]:
    groups: dict[str, dict[tuple[int, str, str], list[Diagnostic]]] = {}
    for left, reason in fixes.left:
        severity = left.severity
        key = (severity.rank, f"{severity.value:<7}  {left.code}  {left.name}", reason)
        groups.setdefault(shown(left.span.source.path), {}).setdefault(key, []).append(left)
    # The files with errors first.
    for path, kinds in sorted(groups.items(), key=lambda of_file: (min(of_file[1])[0], of_file[0])):
        yield f"left in {printable(path)}:"
        for (_, title, reason), findings in sorted(kinds.items(), key=lambda kind: kind[0]):
            row = _row(title + (f" ({_why(reason, findings[0])})" if reason else ""), findings)
            yield output.colored(row, output.SEVERITIES)
        yield ""


def _why(reason: str, diagnostic: Diagnostic) -> str:
    if reason == "info":
        is_safe = diagnostic.fix is not None and diagnostic.fix.safe
        return f"fixed with --select {diagnostic.code}" + " --unsafe-fixes" * (not is_safe)
    return "unsafe fix: needs --unsafe-fixes" if reason == "unsafe" else printable(reason)


def _row(text: str, diagnostics: Iterable[Diagnostic]) -> str:
    lines = [str(line) for line in sorted({diagnostic.span.line for diagnostic in diagnostics})]
    row = f"{text}: line{'s' * (len(lines) > 1)} {few(lines, _MAX_LINES)}"
    return f"  {wrap(row, output.width() - 2, indent=6)}"
