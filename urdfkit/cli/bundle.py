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
def command(asked: dict[str, Any], out: str, consumer: str, force: bool) -> int:
    """Write a robot with all of its files, for use elsewhere.

    OUT has the expanded URDF, the meshes with their materials and textures, and bundle.json, which
    says where each file comes from and what was changed. References are relative to the URDF; for
    ros, OUT is a package and they begin with package://.

    Exit codes: 0 done, 1 the program will reject the robot all the same, 2 a file is missing or
    cannot be read or written, or FILE is a part of a robot.

    Examples:
        urdfkit bundle robot.urdf.xacro -o robot_bundle
        urdfkit bundle robot.urdf.xacro -o robot.zip --for mujoco
    """
    with progress_bar() as bar:
        context = robot(asked, bar)
    bundle, rejections = write(context, out, consumer=consumer, force=force)
    output.page((*_summary(bundle, out), *_reasons(consumer, rejections)))
    return int(bool(rejections))


def _summary(bundle: Bundle, out: str) -> Iterator[str]:
    meshes = len({one.new for one in bundle.renamed if "meshes/" in one.new})
    size = output.size(sum(one.size for one in bundle.contents))
    yield f"wrote {shown(out)}: {bundle.urdf}, {counted(meshes, 'mesh file')}, {size}"
    changed = Counter(one.change for one in bundle.contents if one.change)
    for change, number in changed.items():
        yield from output.indented(f"{counted(number, 'file')}: {change}")
    for element, value in bundle.outside:
        yield from output.indented(f"{element} still names {value}")


def _reasons(consumer: str, rejections: tuple[TargetError, ...]) -> Iterator[str]:
    if rejections:
        yield f"rejected by {CONSUMERS[consumer].title} all the same:"
    for one in rejections:
        yield from output.indented(f"{one.span}: {one.message} ({one.code})")
