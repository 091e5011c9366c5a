"""``urdfkit simulate``: does a robot behave in MuJoCo?"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from urdfkit.cli import output
from urdfkit.cli.decorators import choice, described, in_formats, limited, option
from urdfkit.cli.progress import progress_bar
from urdfkit.cli.robot import one_robot, robot
from urdfkit.errors import UrdfkitError
from urdfkit.output.conversion.options import BASES
from urdfkit.output.simulation import motion, simulate
from urdfkit.text.source import shown

if TYPE_CHECKING:
    from urdfkit.lint.context import Context
    from urdfkit.output.simulation.verdicts import Simulation

#: Pixels of the image and of the animation.
SIZE, MOVING = (1280, 720), (640, 400)


@described("simulate")
@one_robot
@choice("--base", of=BASES, help="Weld the root to the world, or let it stand on a floor.")
@option("--srdf FILE", "SRDF whose disabled pairs do not collide; default: that of the package.")
@option("--gif FILE", "Animation of its release: .gif, .webp or .apng.")
@option("--png FILE", "Image of the end of its release: .png, .webp ...")
@in_formats("text", "json", "junit")
@limited
def command(
    asked: dict[str, Any],
    base: str,
    srdf: str | None,
    gif: str | None,
    png: str | None,
    form: str,
) -> int:
    """Simulate a robot in MuJoCo; report what it should not do.

    Links that overlap or collide while a joint moves; a robot that gains energy or diverges when it
    is released; joints that cannot be moved or held with their effort, or do not follow; a robot
    that sinks, jitters or tips over when it is dropped.

    Exit codes: 0 it behaves, 1 it does not, 2 it cannot be simulated.

    Examples:
        urdfkit simulate robot.urdf.xacro
        urdfkit simulate robot.urdf.xacro --base free --format json
        urdfkit simulate robot.urdf.xacro --gif released.gif
    """
    with progress_bar() as bar:
        context = robot(asked, bar)
    with progress_bar("tests") as bar:
        found = simulate(context, base=base, srdf=srdf, progress=bar)
    if gif or png:
        _draw(context, base, srdf, gif, png)
    if form == "junit":
        from urdfkit.output.simulation.junit import render

        output.write(render(found, context.source.path))
    else:
        output.json_or_page(form, lambda: found.facts, _page(found))
    return int(not found.passes)


def _page(found: Simulation) -> Iterator[str]:
    yield "its root stands on a floor" if found.is_free else "its root is welded to the world"
    if found.srdf:
        yield f"pairs of links that {shown(found.srdf)} disables do not collide"
    for one in found.verdicts:
        yield from output.indented(str(one))


def _draw(context: Context, base: str, srdf: str | None, gif: str | None, png: str | None) -> None:
    from urdfkit import render
    from urdfkit.render.animation import FRAMES

    if gif:
        render.animation_format(gif)
    scene = render.build(context)
    if not scene.items:
        scene = render.build(context, roles=("collision",))
        if not scene.items:
            raise UrdfkitError(f"{context.source.path}: nothing to draw: no geometry")
        output.note("no link has a <visual>: collision shapes are drawn")
    moments = motion(context, base=base, images=FRAMES, srdf=srdf)
    scenes = [scene._replace(frames=frames) for frames in moments]
    if gif:
        shots = render.followed([(one, {}) for one in scenes], size=MOVING)
        render.save_animation(render.animated(shots), gif)
    if png:
        render.save(render.render_image(scenes[-1], ["iso"], size=SIZE), png)
