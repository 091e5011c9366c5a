"""``urdfkit doctor``: what urdfkit has to work with."""

from __future__ import annotations

import os
import platform
import sys
from collections.abc import Iterator
from importlib.metadata import PackageNotFoundError, version

import click

from urdfkit import __version__
from urdfkit.cli import options, output
from urdfkit.engine import check
from urdfkit.resolve import Resolver
from urdfkit.source import Source
from urdfkit.subject import Subject

#: What is looked for, and what it is for.
_PACKAGES = {
    "xacro": "expansion",
    "click": "command line",
    "lxml": "errors of broken XML",
    "PyYAML": "load_yaml in xacro",
    "yourdfpy": "pictures",
    "trimesh": "mesh contents",
    "manifold3d": "mesh repair",
    "pin": "dynamics",
    "coal": "collisions",
}


@click.command("doctor")
@click.argument("words", nargs=-1, metavar="[FILE] [NAME:=VALUE]...")
@click.option("--package", multiple=True, metavar="NAME=FOLDER", help="Where a ROS package is.")
def command(words: tuple[str, ...], package: tuple[str, ...]) -> int:
    """Tell what urdfkit has to work with: programs, packages, configuration, targets.

    With FILE also how its packages are found, which target is chosen and why, and which rules
    do not run on it and why.

    Exit codes: 0 done, 2 FILE cannot be read.
    """
    lines = [*_installed(), "", *_environment()]
    if words:
        lines += ["", *_file({options.FILES: words, "package": package})]
    output.write("\n".join(lines) + "\n")
    return 0


def _installed() -> Iterator[str]:
    yield f"urdfkit {__version__}, Python {platform.python_version()}, {sys.platform}"
    for name, purpose in _PACKAGES.items():
        try:
            yield f"  {name:<12}{version(name):<10}{purpose}"
        except PackageNotFoundError:
            yield f"  {name:<12}{'missing':<10}{purpose}: pip install 'urdfkit[all]'"


def _environment() -> Iterator[str]:
    from urdfkit.config import nearest

    yield f"configuration: {nearest(os.curdir) or 'none'}"
    for name in ("AMENT_PREFIX_PATH", "ROS_PACKAGE_PATH", "ROS_DISTRO"):
        yield f"{name}: {os.environ.get(name) or 'not set'}"


def _file(values: dict[str, tuple[str, ...]]) -> Iterator[str]:
    path = options.files(values)[0]
    packages, arguments = options.packages(values), options.arguments(values)
    resolver = Resolver(packages)
    subject = Subject(Source.read(path), resolver, arguments)
    kind = "plain XML" if subject.reading.xacro is None else "xacro"
    yield f"{path}: {kind}"
    workspace = resolver.packages.workspace(path)
    known = resolver.packages.known(path)
    inside = {name: at for name, at in known.items() if at.startswith(workspace)}
    yield f"  workspace: {workspace}"
    yield from (f"  package {name}: {folder}" for name, folder in sorted(inside.items()))
    if len(known) > len(inside):
        yield f"  and {len(known) - len(inside)} packages in the folders around it"
    if subject.reading.document is not None:
        yield f"  targets: {', '.join(subject.targets.names) or 'none'}"
        yield from (f"    {reason}" for reason in subject.targets.evidence)
    report = check(path, arguments=arguments, packages=packages)
    yield f"  rules: {len(report.rules)} had something to look at"
    yield from (f"  {skip.code or 'file'} skipped: {skip.reason}" for skip in report.skipped)
