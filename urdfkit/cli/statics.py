"""``urdfkit statics``: can the robot hold itself, and does it stand."""

from __future__ import annotations

from collections.abc import Iterator
from math import degrees
from typing import TYPE_CHECKING, Any

import click

from urdfkit.cli import options, output
from urdfkit.cli.decorators import SEED, described, in_formats, limited, option
from urdfkit.cli.posing import posed, positions
from urdfkit.cli.progress import progress_bar
from urdfkit.cli.robot import one_robot, robot
from urdfkit.lint.context import Context
from urdfkit.robot.joints import effort_unit
from urdfkit.robot.model import RobotModel
from urdfkit.robot.stability import VERDICTS, Stability, Standing, standing
from urdfkit.robot.values import number

if TYPE_CHECKING:
    from urdfkit.physics.dynamics.statics import Statics

VERSION = 1

#: Torques in N·m and lengths in m below this are rounding errors.
NOISE = 1e-9

#: Most poses; more take minutes without new results.
MAX_SAMPLES = 1_000_000


@described("statics")
@one_robot
@posed
@option("--payload KG@LINK", "Payload mass at the origin of a link.", multiple=True)
@click.option(
    "--samples", type=click.IntRange(0, MAX_SAMPLES), default=200, help="Sampled configurations."
)
@SEED
@option("--contact LINK", "Contact link with the ground. [default: the lowest]", multiple=True)
@option("--visuals", "Use the visual where a contact link has no collision.")
@in_formats("text", "json")
@limited
def command(
    asked: dict[str, Any],
    payload: tuple[str, ...],
    samples: int,
    seed: int,
    contact: tuple[str, ...],
    visuals: bool,
    form: str,
) -> int:
    """Compare gravity torques with effort limits; test for tipping.

    Gravity torques over many poses (zero, the limits, SAMPLES drawn with SEED, and a search for
    the worst) against the effort of each joint; and the centre of mass over the support polygon,
    at the given pose.

    Exit codes: 0 done, 2 usage or input error.

    Examples:
        urdfkit statics robot.urdf.xacro --payload 2@tool0
        urdfkit statics robot.urdf.xacro --pose ready
    """
    context = robot(asked)
    given = positions(context, asked)
    carried = _payload(context, payload)
    loads = _statics(context, given, carried, samples, seed)
    contacts = [context.model.require_link(link).name for link in contact] or None
    stands = standing(context, given, contacts, payload=carried, visuals=visuals)
    lines = [*render(loads, context.model, posed=bool(given)), ""]
    lines += (line for text in describe(stands) for line in output.wrapped(text))
    output.json_or_page(form, lambda: as_json(loads, stands), lines)
    return 0


def _payload(context: Context, words: tuple[str, ...]) -> dict[str, float]:
    found: dict[str, float] = {}
    for word in words:
        mass, at, link = word.partition("@")
        value = number(mass.removesuffix("kg"))
        if not at or value is None or value < 0:
            raise options.UsageError(f"--payload {word}: expected KG@LINK: a mass in kg and a link")
        context.model.require_link(link)
        found[link] = found.get(link, 0.0) + value
    return found


def _statics(
    context: Context, given: dict[str, float], payload: dict[str, float], samples: int, seed: int
) -> Statics:
    bare = context.dynamics
    from urdfkit.physics.dynamics.robot import Dynamics
    from urdfkit.physics.dynamics.statics import statics

    loaded = Dynamics(context.tree, payload) if payload else bare
    with progress_bar() as bar:
        return statics(loaded, given, samples=samples, seed=seed, progress=bar)


def render(found: Statics, model: RobotModel, *, posed: bool = False) -> Iterator[str]:
    """A table of the joints, the weakest first, with notes."""
    carried = "".join(f" with {mass:g} kg at {link}" for link, mass in found.payload.items())
    poses = f"{found.poses} poses and a search for the worst"
    if not found.searched:
        poses = f"zero pose only: {len(found.loads)} joints are too many to search for the worst"
    yield f"gravity on {found.mass:.6g} kg{carried}, {poses}"
    if found.weightless:
        yield from output.wrapped(f"not on {', '.join(found.weightless)}: it is off in Gazebo")
    if not found.loads:
        yield "no actuated joint"
        return
    yield ""
    first = "at pose" if posed else "at zero"
    rows = [("joint", f"{first:>9} {'worst':>9}  {'effort':>8}  {'used':>6}")]
    for load in found.loads:
        unit = effort_unit(model.joints_by_name[load.joint])
        limit = "unknown" if load.effort is None else f"{load.effort:.4g}"
        used = "" if load.used is None else f"{load.used:.0%}"
        held = output.aligned((load.at_pose, load.worst), NOISE)
        rows.append((load.joint, f"{held}  {limit:>8}  {used:>6}  {unit}"))
    yield from output.two_columns(rows)
    weakest = found.weakest
    if weakest is not None and weakest.worst > NOISE:
        pose = [f"{name} {place:.3f}" for name, place in weakest.pose.items() if abs(place) >= 5e-4]
        yield ""
        yield from output.wrapped(f"highest load: {weakest.joint}, at {', '.join(pose) or 'zero'}")
    for load in found.loads:
        if load.is_exceeded:
            unit = effort_unit(model.joints_by_name[load.joint])
            yield f"{load.joint} exceeds its effort limit: needs >= {load.worst:.4g} {unit}"


def describe(stands: Standing) -> Iterator[str]:
    """The support polygon and the stability of the robot."""
    found = stands.stability
    if stands.links:
        yield f"stands on {', '.join(stands.links)}"
    if found is None:
        yield VERDICTS[stands.verdict]
    else:
        x, y, z = (0.0 if abs(value) < NOISE else value for value in found.center)
        yield f"centre of mass at {x:.4g} {y:.4g} m, {z - found.ground:.4g} m above the ground"
        yield _safety(found, stands.verdict)
    if stands.visual_only:
        counted = "counted" if stands.visuals else "ignored (--visuals counts it)"
        yield f"visual without collision, {counted}: {', '.join(stands.visual_only)}"


def _safety(found: Stability, verdict: str) -> str:
    if found.tips:
        out = f"{-found.margin:.4g} m outside the support polygon"
        unless = VERDICTS[verdict].removeprefix(VERDICTS["tips"])
        return f"tips over {found.tip_direction}{unless}: the centre of mass is {out}"
    slope = f"{degrees(found.angle):.3g} deg"
    return f"margin {found.margin:.4g} m; tips over {found.tip_direction} on a slope of {slope}"


def as_json(found: Statics, stands: Standing) -> dict[str, Any]:
    """The result for JSON; in N·m or N, m, rad."""
    weakest = found.weakest
    return {
        "version": VERSION,
        "mass": found.mass,
        "payload": found.payload,
        "poses": found.poses,
        "weightless": found.weightless,
        "searched": found.searched,
        "joints": [
            {**load._asdict(), "used": load.used, "exceeded": load.is_exceeded}
            for load in found.loads
        ],
        "weakest": weakest.joint if weakest else None,
        "stability": stands.facts(),
    }
