"""``urdfkit inertia``: declared masses and moments, compared with those of the shapes."""

from collections.abc import Iterator, Sequence
from math import inf
from typing import Any

import click

from urdfkit.cli import options, output
from urdfkit.cli.decorators import DIFF, choice, described, in_formats, limited, option
from urdfkit.cli.generated_files import note_generated
from urdfkit.cli.progress import progress_bar
from urdfkit.cli.robot import one_robot, robot
from urdfkit.core.grouping import by_key
from urdfkit.robot.inertia import MassProperties
from urdfkit.robot.inertials.densities import DENSITIES
from urdfkit.robot.inertials.proposals import InertiaProposal, propose, rewrites
from urdfkit.robot.inertials.shape_mass import SOURCES
from urdfkit.text.editing import rewriting
from urdfkit.text.source import shown

VERSION = 1


@described("inertia")
@choice("--from", "source", of=SOURCES, help="Geometry to use.")
@option("--mass KG", "Mass of each link, instead of the declared one.", type=float)
@option("--density KG/M^3", "Density, from which the mass is computed instead.", type=float)
@option(
    "--material NAME",
    f"Material, from whose density the mass is computed: {', '.join(DENSITIES)}.",
    type=click.Choice([*DENSITIES]),
)
@option("--link NAME", "Only this link.", to="links", multiple=True)
@option("--lump", "Treat links connected by fixed joints as one body.")
@option("--write", "Write the suggested values into the source files.")
@DIFF
@in_formats("text", "json")
@one_robot
@limited
def command(
    inputs: dict[str, Any],
    mass: float | None,
    density: float | None,
    material: str | None,
    links: tuple[str, ...],
    write: bool,
    diff: bool,
    format: str,
    **geometry: Any,
) -> int:
    """Compare inertias with those of the geometry; suggest values.

    Shapes count as solids of uniform density with the declared mass. Suggests values for inertias
    that are missing, impossible, rotated, or off by more than a factor of three; with --link, for
    those links.

    Exit codes: 0 done, 1 a value could not be written, 2 the file cannot be read.

    Examples:
        urdfkit inertia robot.urdf.xacro --diff
        urdfkit inertia robot.urdf.xacro --link arm --material steel
    """
    if sum(value is not None for value in (mass, density, material)) > 1:
        raise options.UsageError("--mass, --density and --material cannot be combined")
    if any(value is not None and not 0 < value < inf for value in (mass, density)):
        raise options.UsageError("--mass and --density must be more than 0, and finite")
    if material is not None:
        density = DENSITIES[material]
    with progress_bar("mesh files") as bar:
        context = robot(inputs, bar)
        proposals = propose(context, mass=mass, density=density, links=links, **geometry)
    subset = [proposal for proposal in proposals if links or proposal.is_doubtful]
    if write or diff:
        return _write(subset, is_diff=diff)
    output.json_or_page(format, lambda: as_json(proposals), [*table(proposals), *proposed(subset)])
    return 0


def _write(proposals: Sequence[InertiaProposal], *, is_diff: bool) -> int:
    """Write suggested values, or print them as a diff; the exit code is 1 if a write fails."""
    lines: list[str] = []
    files, unchanged = rewrites(proposals)
    if is_diff:
        output.write_diff("".join(file.diff() for file in files))
    else:
        rewriting.write(files)
        note_generated(files)
        lines += [f"wrote {shown(file.path)}" for file in files]
    lines += [f"link '{name}' is unchanged: {reason}" for name, reason in unchanged.items()]
    output.page(lines or ["nothing to write"] * (not files))
    return int(bool(unchanged))


def table(proposals: Sequence[InertiaProposal]) -> Iterator[str]:
    """Two lines for each link: declared, and computed with the verdict."""
    rows = [("link", f"{'':<9} {'mass / kg':>9} {'ixx, iyy, izz / kg·m²':>29}")]
    notes: dict[str, list[str]] = {}
    for proposal in proposals:
        rows.append((proposal.link.name, _row("declared", proposal.declared)))
        for note in (proposal.reason, *(proposal.shape_mass.notes if proposal.shape_mass else ())):
            if note:
                notes.setdefault(note, []).append(proposal.link.name)
        if proposal.computed is None:
            rows.append(("", proposal.verdict))
            continue
        name = (
            proposal.shape_mass.source.removeprefix("the ").partition(" of ")[0]
            if proposal.shape_mass
            else ""
        )
        factor = f" x{proposal.factor:.3g}" if proposal.verdict == "differs" else ""
        rows.append(("", f"{_row(name, proposal.computed)}  {proposal.verdict}{factor}"))
    yield from output.two_columns(rows)
    for note, names in notes.items():
        yield from output.indented(f"{', '.join(names)}: {note}", first="", rest="  ")


def _row(label: str, values: MassProperties | None) -> str:
    if values is None:
        return f"{label:<9} {'-':>9}"
    tensor = values.tensor
    return f"{label:<9} {output.aligned((values.mass, tensor.ixx, tensor.iyy, tensor.izz))}"


def proposed(proposals: Sequence[InertiaProposal]) -> Iterator[str]:
    """The suggested values; links with the same values share a line."""
    computed = (proposal for proposal in proposals if proposal.computed is not None)
    groups = by_key(("\n".join(proposal.lines()), proposal) for proposal in computed)
    for text, links in groups.items():
        yield ""
        yield from output.indented(", ".join(map(_name, links)) + ":", first="", rest="")
        yield from (f"  {line}" for line in text.splitlines())


def _name(proposal: InertiaProposal) -> str:
    others = f" with {', '.join(proposal.links[1:])}" if len(proposal.links) > 1 else ""
    return f"{proposal.link.name}{others} ({proposal.verdict})"


def as_json(proposals: Sequence[InertiaProposal]) -> dict[str, Any]:
    return {
        "version": VERSION,
        "links": [
            {
                "name": proposal.link.name,
                "links": list(proposal.links),
                "verdict": proposal.verdict,
                "factor": proposal.factor if proposal.factor < float("inf") else None,
                "declared": _properties(proposal.declared),
                "computed": _properties(proposal.computed),
                "source": proposal.shape_mass.source if proposal.shape_mass else None,
                "volume": proposal.shape_mass.properties.mass if proposal.shape_mass else None,
                "notes": list(proposal.shape_mass.notes) if proposal.shape_mass else [],
                "reason": proposal.reason,
            }
            for proposal in proposals
        ],
    }


def _properties(values: MassProperties | None) -> dict[str, Any] | None:
    if values is None:
        return None
    return {"mass": values.mass, "center": list(values.center), "inertia": values.tensor._asdict()}
