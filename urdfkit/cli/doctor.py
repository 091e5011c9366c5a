"""``urdfkit doctor``: the environment and the optional dependencies."""

import os
import platform
import shutil
import sys
from collections.abc import Iterator
from importlib.metadata import PackageNotFoundError, version
from typing import Any

import click

from urdfkit import __version__
from urdfkit.cli import options, output, stdin
from urdfkit.cli.cache_contents import contents
from urdfkit.cli.decorators import (
    CONFIG,
    ISOLATED,
    PACKAGE,
    TARGET,
    TRUST,
    VARIANT,
    described,
    with_options,
)
from urdfkit.cli.progress import working
from urdfkit.core.cache_directory import cache_directory
from urdfkit.core.installation import install_command
from urdfkit.core.words import counted
from urdfkit.lint.config import Config, ConfigError
from urdfkit.lint.context import Context
from urdfkit.lint.discovery import discover
from urdfkit.lint.engine import check
from urdfkit.lint.rule_packages import installed
from urdfkit.ros.targets import Targets, parse
from urdfkit.text.file_kinds import is_launch
from urdfkit.text.source import Source, shown
from urdfkit.text.terminal import YELLOW
from urdfkit.workspace.resolve import Resolver

#: Python packages with their purpose and their extra.
_PACKAGES = (
    ("xacro", "expansion", ""),
    ("click", "command line", ""),
    ("PyYAML", "load_yaml in xacro; controllers", ""),
    ("numpy", "measures, mass properties, rendering", "meshes"),
    ("lxml", "COLLADA meshes", "meshes"),
    ("trimesh", "PLY and glTF meshes; mesh commands", "meshes"),
    ("mapbox-earcut", "polygons in meshes", "meshes"),
    ("manifold3d", "convex hulls; solids", "meshes"),
    ("scipy", "mesh repair, collision, diff", "meshes"),
    ("fast-simplification", "mesh simplify", "meshes"),
    ("vhacdx", "mesh decompose, mesh collision", "meshes"),
    ("coacd", "mesh decompose --engine coacd", "decompose"),
    ("pin", "dynamics", "dynamics"),
    ("coal", "collisions", "dynamics"),
    ("mujoco", "convert, simulate", "simulate"),
    ("urdf-usd-converter", "convert --to usd", "usd"),
    ("Pillow", "images", "render"),
    ("Jinja2", "report pages", "report"),
    ("starlette", "the viewer", "report"),
    ("uvicorn", "the viewer", "report"),
    ("yourdfpy", "conversion to yourdfpy", "exchange"),
    ("pygls", "the language server", "lsp"),
    ("mcp", "the tools for agents", "mcp"),
    ("dask", "scan on several machines", "scan"),
    ("pyarrow", "scan to Parquet", "scan"),
)
_PROGRAMS = {"git": "comparison with an earlier git revision"}


@described("doctor")
@click.argument("words", nargs=-1, metavar="[FILE] [NAME:=VALUE]...")
@with_options(TRUST, ISOLATED, CONFIG, VARIANT, TARGET, PACKAGE)
def command(words: tuple[str, ...], **values: Any) -> int:
    """Show the environment and optional dependencies.

    With FILE, a model or a directory, also shows what a check of it uses: the packages found, the
    targets and why they were detected, and the rules that are skipped and why.

    Exit codes: 0 done, 2 FILE or the configuration cannot be read.

    Examples:
        urdfkit doctor
        urdfkit doctor robot.urdf.xacro
    """
    values[options.FILES] = words
    near = options.files(values)[0] if words else os.curdir
    lines = [*_installed(), "", *_environment()]
    try:
        config = options.config(values, near)
        lines.append(f"configuration: {shown(config.path) if config else 'none'}")
    except ConfigError as error:
        if words:
            raise
        config = None
        lines.append(f"configuration: {error}")
    if words:
        describe = _directory if os.path.isdir(near) else _file
        with working():
            lines += ["", *describe(near, values, config or Config())]
    output.page(lines, {r"\bmissing(?= {7}\S)": YELLOW})
    return 0


def _installed() -> Iterator[str]:
    yield f"urdfkit {__version__}, Python {platform.python_version()}, {sys.platform}"
    for name, purpose, extra in _PACKAGES:
        try:
            yield f"  {name:<21}{version(name):<14}{purpose}"
        except PackageNotFoundError:
            yield f"  {name:<21}{'missing':<14}{purpose}"
            yield f"  {'':<21}{install_command(extra)}"
    for name, purpose in _PROGRAMS.items():
        yield f"  {name:<21}{'found' if shutil.which(name) else 'missing':<14}{purpose}"
    for name, module in sorted(installed().items()):
        yield f"  other rule packages: {name} ({module}); run with --rules {name}"


def _environment() -> Iterator[str]:
    for name in ("ROS_DISTRO", "AMENT_PREFIX_PATH", "ROS_PACKAGE_PATH", "GZ_SIM_RESOURCE_PATH"):
        yield f"{name}: {os.environ.get(name) or 'not set'}"
    cache = cache_directory()
    stored = contents()
    summary = f" ({len(stored.files)} entries, {stored.size / 1e6:.1f} MB)" if cache else ""
    yield f"cache: {cache or 'none'}{summary}"


def _directory(path: str, values: dict[str, Any], config: Config) -> Iterator[str]:
    """The entry points of a directory, and the skipped files."""
    resolver = Resolver({**config.packages, **options.packages(values)})
    discovered = discover(path, config, resolver)
    configured = " (named by the configuration)" if config.robots else ""
    yield f"{path}: {counted(len(discovered.robots), 'robot')}{configured}"
    for robot in discovered.robots:
        words = [f"{name}:={value}" for name, value in robot.arguments.items()]
        yield "  " + " ".join([shown(robot.file), *words])
    for library in discovered.libraries:
        yield f"  {shown(library)}: defines no link, and no file includes it"
    for file, reason in discovered.others.items():
        yield f"  {shown(file)}: {reason}"
    yield from _packages(os.path.join(path, "x"), resolver)


def _file(path: str, values: dict[str, Any], config: Config) -> Iterator[str]:
    """The packages, targets and rules of a check of a description."""
    packages = {**config.packages, **options.packages(values)}
    entry = config.entry(path, options.arguments(values), values["variant"])
    names = options.words(values, "target") or config.targets
    resolver = Resolver(packages)
    chosen_targets = parse(names) if names else None
    trust = values["trust"] or config.trust
    source = Source.of(stdin.opened(path))
    context = Context(source, resolver, entry.arguments, trust=trust, targets=chosen_targets)
    words = (f"{name}:={value}" for name, value in entry.arguments.items())
    kind = "plain XML" if context.reading.xacro is None else "xacro"
    if context.is_bringup:
        kind = "launch file" if is_launch(path) else "parameter file"
    yield f"{path}: {' '.join((kind, *words))}"
    yield from _packages(path, resolver)
    if context.reading.document is not None:
        yield from _targets(context, chosen_targets)
    report = check(
        source,
        arguments=entry.arguments,
        packages=packages,
        targets=names,
        trust=trust,
        config=config,
    )
    yield f"  rules: {len(report.rules)} apply"
    yield from (f"  {skip.code or 'file'} skipped: {skip.reason}" for skip in report.skipped)


def _packages(path: str, resolver: Resolver) -> Iterator[str]:
    """The package search of a file: its root with the reason, and other directories."""
    packages = resolver.packages
    root = packages.root(path)
    known = packages.known(path)
    cause = f"because of {root.mark}" if root.mark else "no repository or workspace found around it"
    yield f"  packages are searched in {shown(root.directory)} ({cause})"
    siblings = [level.root for level in packages.levels(path) if not level.inside]
    yield from (f"    and next to it, in {shown(directory)}" for directory in siblings)
    for name, directory in sorted(known.items()):
        if name not in packages.explicit:
            yield f"    package {name}: {shown(directory)}"
    for name, directory in sorted(packages.explicit.items()):
        yield f"    package {name}: {shown(directory)} (given)"
    for variable, directories in (
        ("AMENT_PREFIX_PATH", packages.prefixes),
        ("ROS_PACKAGE_PATH", packages.ros1_paths),
    ):
        yield from (f"    and in {variable}: {shown(directory)}" for directory in directories)


def _targets(context: Context, targets: Targets | None) -> Iterator[str]:
    if targets is not None:
        yield f"  targets: {', '.join(targets.names)} (given)"
        return
    inferred = context.inferred_targets
    yield f"  targets: {', '.join(inferred.names) or 'none detected; select with --target'}"
    yield from (f"    {reason}" for reason in inferred.evidence)
