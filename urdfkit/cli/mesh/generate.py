"""``urdfkit mesh generate``: meshes for files that are missing, empty or broken."""

from collections.abc import Iterator
from typing import Any

import click

from urdfkit.cli import options, output
from urdfkit.cli.decorators import described, limited, option
from urdfkit.cli.progress import working
from urdfkit.cli.robot import read_by_options, robot
from urdfkit.core.spatial import Vector
from urdfkit.core.words import counted
from urdfkit.lint.context import Context
from urdfkit.mesh.parts import PARTS, RealPart
from urdfkit.robot.assets.placeholder_meshes import (
    GeneratedMeshes,
    generate,
    generate_missing,
    generate_part,
)
from urdfkit.text.source import shown

_PARTS = {part.key: part for part in PARTS}


def _is_robot(files: list[str]) -> bool:
    return bool(files) and files[0].endswith((".urdf", ".xacro", ".xml"))


@described("generate")
@click.argument("words", nargs=-1, metavar="[MESH] [NAME:=VALUE]...")
@option("--model FILE", "Robot that references the mesh.")
@option(
    "--part PART",
    f"Part to generate: {', '.join(_PARTS)}.",
    to="part_name",
    type=click.Choice([*_PARTS]),
)
@option("--size X Y Z", "Size of the mesh in metres.", type=(float, float, float))
@option("--force", "Replace the file even if it is a valid mesh.")
@option("--dry-run", "Print what would be generated; write nothing.")
@read_by_options
@limited
def command(
    words: tuple[str, ...],
    model: str | None,
    part_name: str | None,
    size: Vector | None,
    force: bool,
    dry_run: bool,
    **inputs: Any,
) -> int:
    """Generate a mesh for a file that is missing, empty or broken.

    MESH is the reference as the robot writes it, such as package://gazebo_pkg/meshes/hokuyo.dae;
    without it, every missing, empty and broken mesh of the robot is generated. The part is chosen
    by the names of file and link, its pose and size by the other shapes of the link. Without
    --model, MESH is a file, and --part selects the part.

    Exit codes: 0 done, 1 a mesh could not be generated, 2 usage or input error.

    Examples:
        urdfkit mesh generate --model robot.urdf.xacro
        urdfkit mesh generate lidar.dae --part rplidar_a2
    """
    files = [word for word in words if ":=" not in word]
    if len(files) > 1:
        raise options.UsageError("pass one mesh, or none to generate all that are missing")
    part = _PARTS[part_name] if part_name else None
    if model is None:
        result = _without_robot(files, part, size, force)
    else:
        arguments = (word for word in words if ":=" in word)
        context = robot({**inputs, options.FILES: (model, *arguments)})
        with working():
            result = _of_robot(context, files, part, size, force)
    if not dry_run:
        for mesh in result.generated:
            mesh.write()
    output.page(render(result, dry_run))
    return int(bool(result.not_generated))


def _without_robot(
    files: list[str], part: RealPart | None, size: Vector | None, force: bool
) -> GeneratedMeshes:
    if not files or part is None:
        hint = f" (did you mean --model {files[0]}?)" if _is_robot(files) else ""
        raise options.UsageError(
            f"pass the robot with --model{hint}; or pass a file and select the part with --part"
        )
    return GeneratedMeshes.of([generate_part(files[0], part, size, force=force)])


def _of_robot(
    robot: Context, files: list[str], part: RealPart | None, size: Vector | None, force: bool
) -> GeneratedMeshes:
    if files:
        mesh = generate(robot, files[0], part=part, size=size, force=force)
        return GeneratedMeshes.of([mesh])
    if part or size or force:
        raise options.UsageError("--part, --size and --force apply to one mesh; pass its name")
    return generate_missing(robot)


def render(result: GeneratedMeshes, dry_run: bool) -> Iterator[str]:
    """The generated meshes, and the failures."""
    if not result.generated and not result.not_generated:
        yield "nothing is missing"
    for mesh in result.generated:
        yield f"{'would write' if dry_run else 'wrote'} {shown(mesh.path)}"
        yield from output.indented(f"the file {mesh.defect}")
        yield from output.indented(mesh.reason)
        materials = counted(len(mesh.mesh.parts), "material")
        yield f"  {len(mesh.mesh.faces)} triangles, {materials}"
    for failure in result.not_generated:
        yield f"cannot generate {shown(failure.path)}"
        yield from output.indented(f"the file {failure.defect}")
        yield from output.indented(failure.reason)
