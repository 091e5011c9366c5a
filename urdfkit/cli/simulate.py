"""``urdfkit simulate``: faults of a robot in MuJoCo."""

import os
from collections.abc import Iterable, Iterator
from itertools import groupby
from typing import Any

from urdfkit.cli import output
from urdfkit.cli.decorators import choice, described, in_formats, limited, option
from urdfkit.cli.progress import progress_bar, working
from urdfkit.cli.robot import one_robot, robot
from urdfkit.errors import UrdfkitError
from urdfkit.lint.context import Context
from urdfkit.output.conversion.options import BASES
from urdfkit.output.simulation import motion, simulate
from urdfkit.physics.verdicts import Simulation
from urdfkit.text.source import shown
from urdfkit.text.terminal import GREEN, RED, YELLOW

#: Pixels of the image and of the animation.
SIZE, MOVING = (1280, 720), (640, 400)
MOVING_FORMATS = (".gif", ".webp", ".apng")
#: Most verdicts of a test with the same result that the text lists: the links of a hand whose
#: meshes are in millimetres overlap in 300 pairs.
_MOST = 10
COLORS = {r"(?<=^  )FAILS\b": RED, r"(?<=^  )warns\b": YELLOW, r"(?<=^  )passes\b": GREEN}


@described("simulate")
@one_robot
@choice("--base", of=BASES, help="Weld the root to the world, or let it stand on a floor.")
@option("--srdf FILE", "SRDF whose disabled pairs do not collide; default: that of the package.")
@option(
    "-o, --output FILE",
    "Animation of the release (.gif, .webp, .apng) or image of its end (.png, .jpg); repeatable.",
    to="images",
    multiple=True,
)
@in_formats("text", "json", "junit")
@limited
def command(
    inputs: dict[str, Any], base: str, srdf: str | None, images: tuple[str, ...], format: str
) -> int:
    """Simulate a robot in MuJoCo; report faulty behaviour.

    Links that overlap or collide while a joint moves; a robot that gains energy or diverges when it
    is released; joints that cannot be moved or held with their effort, or do not follow commands; a
    robot that sinks, jitters or tips over when it is dropped.

    Exit codes: 0 no faults, 1 faults, 2 the robot cannot be simulated.

    Examples:
        urdfkit simulate robot.urdf.xacro
        urdfkit simulate robot.urdf.xacro --base free --format json
        urdfkit simulate robot.urdf.xacro -o released.gif
    """
    with progress_bar() as bar:
        context = robot(inputs, bar)
    with progress_bar("tests") as bar:
        simulation = simulate(context, base=base, srdf=srdf, progress=bar)
    if images:
        _draw(context, base, srdf, images)
    if format == "junit":
        from urdfkit.output.simulation.junit import render

        output.write(render(simulation, context.source.path))
    else:
        page = [*_page(simulation), *(f"wrote {shown(path)}" for path in images)]
        output.json_or_page(format, lambda: simulation.facts, page, COLORS)
    return int(not simulation.passes)


def _page(simulation: Simulation) -> Iterator[str]:
    yield "its root stands on a floor" if simulation.is_free else "its root is welded to the world"
    if simulation.srdf:
        yield f"pairs of links that {shown(simulation.srdf)} disables do not collide"
    kinds = groupby(simulation.verdicts, lambda one: (one.test, one.passes, one.warns))
    for _, verdicts in kinds:
        alike = [*verdicts]
        for verdict in alike[:_MOST]:
            yield from output.indented(str(verdict))
        if len(alike) > _MOST:
            yield f"  and {len(alike) - _MOST} more like these; --format json has all"


def _draw(context: Context, base: str, srdf: str | None, paths: Iterable[str]) -> None:
    from urdfkit import render
    from urdfkit.render.animation import FRAMES

    scene = render.build(context)
    if not scene.items:
        scene = render.build(context, roles=("collision",))
        if not scene.items:
            raise UrdfkitError(f"{context.source.path}: nothing to draw: no geometry")
        output.note("no link has a <visual>: collision shapes are drawn")
    with working():
        moments = motion(context, base=base, images=FRAMES, srdf=srdf)
        scenes = [scene._replace(frames=frames) for frames in moments]
        for path in paths:
            if os.path.splitext(path)[1].lower() in MOVING_FORMATS:
                shots = render.followed([(frame, {}) for frame in scenes], size=MOVING)
                render.save_animation(render.animated(shots), path)
            else:
                render.save(render.render_image(scenes[-1], ["iso"], size=SIZE), path)
