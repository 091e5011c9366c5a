"""``urdfkit mesh collision``: simple collisions for links with visual meshes."""

from collections.abc import Iterator, Sequence
from typing import Any

from urdfkit.cli import options, output
from urdfkit.cli.decorators import DIFF, described, limited, option
from urdfkit.cli.generated_files import note_generated
from urdfkit.cli.mesh import tables
from urdfkit.cli.progress import progress_bar
from urdfkit.cli.robot import one_robot, robot
from urdfkit.robot.assets.collision_shapes import CollisionProposal, edited, propose
from urdfkit.text.source import shown


@described("collision")
@option("--error METRES", "Largest distance that a shape may stick out of the mesh.", type=float)
@option("--link NAME", "Only this link, even if it has a collision.", to="links", multiple=True)
@option("--most N", "Maximum number of convex pieces.", type=int, default=8)
@option("--write", "Write the collisions and their mesh files.")
@DIFF
@one_robot
@limited
def command(
    inputs: dict[str, Any],
    error: float | None,
    links: tuple[str, ...],
    most: int,
    write: bool,
    diff: bool,
) -> int:
    """Suggest simple collision geometry to replace detailed meshes.

    For every link whose collision is missing or is its visual mesh. Fits a box, a cylinder and a
    sphere, then the convex hull, then convex pieces, and selects the simplest that sticks out of
    the mesh by no more than --error (default: 5 % of its diagonal).

    Exit codes: 0 done, 1 a link could not be written, 2 usage or input error.

    Examples:
        urdfkit mesh collision robot.urdf.xacro --diff
        urdfkit mesh collision robot.urdf.xacro --link arm --write
    """
    if (error is not None and not error > 0) or most < 1:
        raise options.UsageError("--error must be more than 0, --most 1 or more")
    context = robot(inputs)
    with progress_bar() as bar:
        proposals = propose(context, error=error, links=links, most=most, progress=bar)
    lines = [*render(proposals)]
    unchanged: dict[str, str] = {}
    if write or diff:
        edits = edited(context, proposals)
        unchanged = edits.unchanged
        if diff:
            output.write_diff("".join(file.diff() for file in edits.files))
            lines = [f"# new file {shown(path)}" for path in edits.meshes]
        else:
            lines += [f"wrote {shown(path)}" for path in edits.write()]
            note_generated(edits.files)
        lines += [f"link '{name}' is unchanged: {reason}" for name, reason in unchanged.items()]
    output.write("".join(f"{line}\n" for line in lines))
    return int(bool(unchanged))


def render(proposals: Sequence[CollisionProposal]) -> Iterator[str]:
    """The candidate shapes of each visual, and the chosen one."""
    if not proposals:
        yield "every link with a visual mesh has a collision of its own"
    for proposal in proposals:
        yield f"link '{proposal.link.name}'"
        if proposal.reason:
            yield from output.indented(proposal.reason)
        for fits, bound in zip(proposal.fits, proposal.bounds, strict=True):
            tried = ", ".join(f"{shape} {tables.length(shape.error)}" for shape in fits.tried)
            yield from output.indented(f"sticks out by: {tried}")
            verdict = "within" if fits.within else "none within"
            reason = fits.why or f"{verdict} {tables.length(bound)}"
            yield f"  selected: {fits.best} ({reason})"
            yield f"  mesh sticks out of it by: {tables.length(fits.best.missing)}"
