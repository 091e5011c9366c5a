"""``urdfkit statics``: gravity torques against effort limits, and stability."""

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
from urdfkit.core.words import few
from urdfkit.lint.context import Context
from urdfkit.robot.model import RobotModel
from urdfkit.robot.stability import VERDICTS, Stability, StandingVerdict, standing_verdict
from urdfkit.robot.values import number

if TYPE_CHECKING:
    from urdfkit.physics.dynamics.statics import Statics

VERSION = 1

#: Torques in N·m and lengths in m below this are rounding errors.
NOISE = 1e-9

#: Most poses; more take minutes without new results.
MAX_SAMPLES = 1_000_000

#: Most links that a note names.
_NAMED = 8


@described("statics")
@one_robot
@posed
@option("--payload KG@LINK", "Payload mass at the origin of a link.", multiple=True)
@option("--samples N", "Sampled configurations.", type=click.IntRange(0, MAX_SAMPLES), default=200)
@SEED
@option("--contact LINK", "Contact link with the ground. [default: the lowest]", multiple=True)
@option("--visual", "Use the visual where a contact link has no collision.")
@in_formats("text", "json")
@limited
def command(
    inputs: dict[str, Any],
    payload: tuple[str, ...],
    samples: int,
    seed: int,
    contact: tuple[str, ...],
    visual: bool,
    format: str,
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
    context = robot(inputs)
    pose = positions(context, inputs)
    payload_masses = _payload(context, payload)
    loads = _statics(context, pose, payload_masses, samples, seed)
    contacts = [context.model.require_link(link).name for link in contact] or None
    contact_result = standing_verdict(
        context, pose, contacts, payload=payload_masses, visuals=visual
    )
    lines = [*render(loads, context.model, posed=bool(pose)), ""]
    lines += (line for text in describe(contact_result) for line in output.wrapped(text))
    output.json_or_page(format, lambda: as_json(loads, contact_result), lines)
    return 0


def _payload(context: Context, words: tuple[str, ...]) -> dict[str, float]:
    masses: dict[str, float] = {}
    for word in words:
        mass, at, link = word.partition("@")
        value = number(mass.removesuffix("kg"))
        if not at or value is None or value < 0:
            raise options.UsageError(f"--payload {word}: expected KG@LINK: a mass in kg and a link")
        context.model.require_link(link)
        masses[link] = masses.get(link, 0.0) + value
    return masses


def _statics(
    context: Context, pose: dict[str, float], payload: dict[str, float], samples: int, seed: int
) -> Statics:
    unloaded = context.dynamics
    from urdfkit.physics.dynamics.robot import Dynamics
    from urdfkit.physics.dynamics.statics import statics

    loaded = Dynamics(context.tree, payload) if payload else unloaded
    with progress_bar() as bar:
        return statics(loaded, pose, samples=samples, seed=seed, progress=bar)


def render(loads: Statics, model: RobotModel, *, posed: bool = False) -> Iterator[str]:
    """A table of the joints, the weakest first, with notes."""
    payload = "".join(f" with {mass:g} kg at {link}" for link, mass in loads.payload.items())
    poses = f"{loads.poses} poses and a search for the worst"
    if not loads.searched:
        poses = f"zero pose only: {len(loads.loads)} joints are too many to search for the worst"
    if not loads.loads:
        poses = "no actuated joint"
    if not loads.mass:
        poses = "no link has a mass"
    yield f"gravity on {loads.mass:.6g} kg{payload}, {poses}"
    if loads.weightless:
        yield from output.wrapped(f"no gravity in Gazebo on {few(loads.weightless, _NAMED)}")
    if not loads.loads or not loads.mass:
        return
    yield ""
    first = "at pose" if posed else "at zero"
    rows = [("joint", f"{first:>9} {'worst':>9}  {'effort':>8}  {'used':>6}")]
    for load in loads.loads:
        unit = model.joints_by_name[load.joint].effort_unit
        limit = "unknown" if load.effort is None else f"{load.effort:.4g}"
        used = "" if load.used is None else f"{load.used:.0%}"
        held = output.aligned((load.at_pose, load.worst), NOISE)
        rows.append((load.joint, f"{held}  {limit:>8}  {used:>6}  {unit}"))
    yield from output.two_columns(rows)
    weakest = loads.weakest
    if weakest is not None and weakest.worst > NOISE:
        pose = [
            f"{name} {place:.3f} {model.joints_by_name[name].unit}"
            for name, place in weakest.pose.items()
            if abs(place) >= 5e-4
        ]
        yield ""
        yield from output.wrapped(f"highest load: {weakest.joint}, at {', '.join(pose) or 'zero'}")
    for load in loads.loads:
        if load.is_exceeded:
            unit = model.joints_by_name[load.joint].effort_unit
            yield f"{load.joint} exceeds its effort limit: needs >= {load.worst:.4g} {unit}"


def describe(contact_result: StandingVerdict) -> Iterator[str]:
    """The support polygon and the stability of the robot."""
    stability = contact_result.stability
    if contact_result.links:
        yield f"stands on {', '.join(contact_result.links)}"
    if contact_result.unread:
        names = few(contact_result.unread, _NAMED)
        yield f"not known what it stands on: no collision mesh can be read of {names}"
        yield "'--contact LINK' selects other links"
    elif stability is None:
        yield VERDICTS[contact_result.verdict]
    else:
        x, y, z = (0.0 if abs(value) < NOISE else value for value in stability.center)
        yield f"centre of mass at {x:.4g} {y:.4g} m, {z - stability.ground:.4g} m above the ground"
        yield _safety(stability, contact_result.verdict)
    if contact_result.visual_only:
        counted = "counted" if contact_result.visuals else "ignored (--visual counts it)"
        yield f"visual without collision, {counted}: {', '.join(contact_result.visual_only)}"


def _safety(stability: Stability, verdict: str) -> str:
    if stability.tips:
        distance = f"{-stability.margin:.4g} m outside the support polygon"
        condition = VERDICTS[verdict].removeprefix(VERDICTS["tips"])
        return f"tips over {stability.tip_direction}{condition}: the centre of mass is {distance}"
    slope = f"{stability.tip_direction} on a slope of {degrees(stability.angle):.3g} deg"
    return f"margin {stability.margin:.4g} m; tips over {slope}"


def as_json(loads: Statics, contact_result: StandingVerdict) -> dict[str, Any]:
    """The result for JSON; in N·m or N, m, rad."""
    weakest = loads.weakest
    return {
        "version": VERSION,
        "mass": loads.mass,
        "payload": loads.payload,
        "poses": loads.poses,
        "weightless": loads.weightless,
        "searched": loads.searched,
        "joints": [
            {**load._asdict(), "used": load.used, "exceeded": load.is_exceeded}
            for load in loads.loads
        ],
        "weakest": weakest.joint if weakest else None,
        "stability": contact_result.facts(),
    }
