"""``urdfkit mass``: the mass properties of every link and of the whole robot."""

from collections.abc import Iterable, Iterator
from typing import Any

from urdfkit.cli import output
from urdfkit.cli.decorators import described, in_formats, limited
from urdfkit.cli.posing import posed, positions
from urdfkit.cli.progress import progress_bar
from urdfkit.cli.robot import one_robot, robot
from urdfkit.core.spatial import Rotation, Vector
from urdfkit.core.strict_json import dumped
from urdfkit.output.mass_table import MassRow, MassTable, mass_properties
from urdfkit.robot.inertia import MassProperties
from urdfkit.text.markdown import escape, table

VERSION = 1


@described("mass")
@one_robot
@posed
@in_formats("text", "json", "csv", "markdown")
@limited
def command(inputs: dict[str, Any], format: str) -> int:
    """Show the mass properties of every link and of the whole robot.

    Declared mass, centre of mass and principal moments, next to the density and the moments of the
    link's geometry. The properties of the whole robot are for one pose.

    Exit codes: 0 done, 2 the file or the pose cannot be read.

    Examples:
        urdfkit mass robot.urdf.xacro
        urdfkit mass robot.urdf.xacro --format csv > masses.csv
    """
    with progress_bar("mesh files") as bar:
        context = robot(inputs, bar)
        masses = mass_properties(context, positions(context, inputs))
    if format == "text":
        output.page(render(masses))
    else:
        write = {"json": as_json, "csv": as_csv, "markdown": as_markdown}[format]
        output.write(write(masses))
    return 0


def render(masses: MassTable) -> Iterator[str]:
    """Two tables: masses and centres, then moments and axes."""
    if masses.rows and not any(row.properties.mass for row in masses.rows):
        yield "no link has a mass; 'urdfkit inertia FILE --density KG/M^3' suggests values"
        return
    yield from _masses(masses)
    yield ""
    yield from _moments(masses)
    yield from _unknown(masses)


def _masses(masses: MassTable) -> Iterator[str]:
    head = f"{'mass / kg':>9} {'share':>6} {'centre of mass / m':>29} {'kg/m³':>8}"
    rows = [("link", head)]
    for row in masses.rows:
        density = "" if row.density is None else f"{row.density:.4g}"
        share = row.properties.mass / masses.whole.mass if masses.whole.mass else 0.0
        mass, center = row.properties.mass, _three(row.properties.center)
        rows.append((row.link, f"{mass:>9.5g} {share:>6.1%} {center} {density:>8}"))
    body = masses.whole.properties
    center = _three(body.center) if body else ""
    rows.append(("total", f"{masses.whole.mass:>9.6g} {'':>6} {center}"))
    yield from output.two_columns(rows)


def _moments(masses: MassTable) -> Iterator[str]:
    yield "principal moments in kg·m², their axes, and the moments of the shapes"
    rows = []
    for row in masses.rows:
        shapes = _three(row.of_shapes[0], 8) if row.of_shapes else ""
        rows.append((row.link, f"{_three(row.moments, 8)}  {_axes(row.axes):<7} {shapes}"))
    if masses.moments and masses.axes:
        rows.append(("total", f"{_three(masses.moments, 8)}  {_axes(masses.axes)}"))
    yield from output.two_columns(rows)


def _unknown(masses: MassTable) -> Iterator[str]:
    reasons: dict[str, list[str]] = {}
    frame_note = f"centre of mass in the frame of {masses.whole.root}"
    if masses.whole.mass:
        reasons[
            f"no centre of mass: {masses.whole.reason}" if masses.whole.reason else frame_note
        ] = ["total"]
    for row in masses.rows:
        for reason in (row.reason, *(row.shape_mass.notes if row.shape_mass else ())):
            if reason:
                reasons.setdefault(reason, []).append(row.link)
    if reasons:
        yield ""
    for reason, names in reasons.items():
        yield from output.wrapped(f"{', '.join(names)}: {reason}")


def _axes(axes: Rotation) -> str:
    """The axes as letters if they are parallel to the link's axes, else ``rotated``."""
    letters = []
    for column in zip(*axes, strict=True):
        largest = max(range(3), key=lambda index: abs(column[index]))
        if abs(column[largest]) < 1 - 1e-6:
            return "rotated"
        letters.append("xyz"[largest])
    return " ".join(letters)


def _three(values: Iterable[float], width: int = 9) -> str:
    numbers = list(values)
    noise = 1e-9 * max(map(abs, numbers))
    return output.aligned(numbers, noise, width)


def as_json(masses: MassTable) -> str:
    """The table for JSON; in kg, m, kg·m² and kg/m³, axes as columns."""
    document = {
        "version": VERSION,
        "root": masses.whole.root,
        "total": _total(masses),
        "links": [_link(row) for row in masses.rows],
    }
    return dumped(document)


def _total(masses: MassTable) -> dict[str, Any]:
    body, moments, axes = masses.whole.properties, masses.moments, masses.axes
    known = _numbers(body, moments, axes) if body and moments and axes else {}
    return {**known, "mass": masses.whole.mass, "reason": masses.whole.reason}


def _numbers(body: MassProperties, moments: Vector, axes: Rotation) -> dict[str, Any]:
    return {
        "mass": body.mass,
        "center": list(body.center),
        "inertia": body.tensor._asdict(),
        "principal_moments": list(moments),
        "principal_axes": [list(row) for row in axes],
    }


def _link(row: MassRow) -> dict[str, Any]:
    shapes: dict[str, Any] | None = None
    if row.shape_mass and row.of_shapes:
        moments, axes = row.of_shapes
        shapes = {
            "source": row.shape_mass.source,
            "volume": row.shape_mass.properties.mass,
            "center": list(row.shape_mass.properties.center),
            "principal_moments": list(moments),
            "principal_axes": [list(line) for line in axes],
            "notes": list(row.shape_mass.notes),
        }
    known = {"density": row.density, "shapes": shapes, "reason": row.reason}
    return {"name": row.link, **_numbers(row.properties, row.moments, row.axes), **known}


def as_csv(masses: MassTable) -> str:
    """One row for each link, and one without a name for the whole robot."""
    from urdfkit.output.report.csv import cell  # with all of the report

    header = (
        "link mass cx cy cz ixx ixy ixz iyy iyz izz i1 i2 i3 volume density shape_i1 shape_i2 "
        "shape_i3"
    )
    rows: list[list[object]] = []
    for row in masses.rows:
        shapes: list[float | str] = [""] * 5
        if row.shape_mass and row.of_shapes and row.density is not None:
            shapes = [row.shape_mass.properties.mass, row.density, *row.of_shapes[0]]
        mass, center, tensor = row.properties
        rows.append([cell(row.link), mass, *center, *tensor, *row.moments, *shapes])
    body, moments = masses.whole.properties, masses.moments
    known = [*body.center, *body.tensor, *moments] if body and moments else [""] * 12
    rows.append(["", masses.whole.mass, *known, *[""] * 5])
    return output.csv_text(header.split(), rows)


def as_markdown(masses: MassTable) -> str:
    """A table for a README or an issue."""
    moments_of = "principal moments / kg·m²"
    header = ["link", "mass / kg", "centre of mass / m", moments_of, "density / kg/m³"]
    rows = [
        [
            escape(row.link),
            f"{row.properties.mass:.6g}",
            _plain(row.properties.center),
            _plain(row.moments),
            "" if row.density is None else f"{row.density:.4g}",
        ]
        for row in masses.rows
    ]
    body, moments = masses.whole.properties, masses.moments
    known = [_plain(body.center), _plain(moments)] if body and moments else ["", ""]
    rows.append(["**total**", f"**{masses.whole.mass:.6g}**", *known, ""])
    return table(header, rows)


def _plain(values: Iterable[float]) -> str:
    return " ".join(_three(values).split())
