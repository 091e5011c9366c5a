"""``urdfkit bundle``: a robot with all of its files, for another machine or program."""

from collections import Counter
from collections.abc import Iterator
from typing import Any

from urdfkit.cli import output
from urdfkit.cli.decorators import OUT, choice, described, limited, option
from urdfkit.cli.progress import progress_bar
from urdfkit.cli.robot import one_robot, robot
from urdfkit.core.words import counted
from urdfkit.output.bundle import Bundle
from urdfkit.output.bundle.consumers import CONSUMERS
from urdfkit.output.bundle.writing import TargetError
from urdfkit.output.bundle.writing import bundle as write
from urdfkit.text.source import shown


@described("bundle")
@one_robot
@OUT
@choice("--for", "consumer", of=CONSUMERS, help="Convert the meshes that this program cannot read.")
@option("--force", "Replace OUT if it is a bundle.")
@limited
def command(inputs: dict[str, Any], out: str, consumer: str, force: bool) -> int:
    """Write a robot with all of its files, for use elsewhere.

    OUT contains the expanded URDF, the meshes with their materials and textures, and bundle.json,
    which lists the source of each file and its changes. References are relative to the URDF; for
    ros, OUT is a package and they begin with package://.

    Exit codes: 0 done, 1 the robot has errors for the program, 2 a file is missing or
    cannot be read or written, or FILE is a part of a robot.

    Examples:
        urdfkit bundle robot.urdf.xacro -o robot_bundle
        urdfkit bundle robot.urdf.xacro -o robot.zip --for mujoco
    """
    with progress_bar() as bar:
        context = robot(inputs, bar)
    bundle, rejections = write(context, out, consumer=consumer, force=force)
    output.page((*_summary(bundle, out), *_reasons(consumer, rejections)))
    return int(bool(rejections))


def _summary(bundle: Bundle, out: str) -> Iterator[str]:
    meshes = len({reference.new for reference in bundle.renamed if "meshes/" in reference.new})
    size = output.size(sum(entry.size for entry in bundle.contents))
    yield f"wrote {shown(out)}: {bundle.urdf}, {counted(meshes, 'mesh file')}, {size}"
    changed = Counter(entry.change for entry in bundle.contents if entry.change)
    for change, number in changed.items():
        yield from output.indented(f"{counted(number, 'file')}: {change}")
    for element, value in bundle.outside:
        yield from output.indented(f"{element} still refers to {value}")


def _reasons(consumer: str, rejections: tuple[TargetError, ...]) -> Iterator[str]:
    if rejections:
        yield f"errors for {CONSUMERS[consumer].title}:"
    yield from output.errors((str(one.span), one.message, one.code) for one in rejections)
