"""Tables with the properties of meshes."""

from collections.abc import Sequence

from urdfkit.mesh.health import Health
from urdfkit.mesh.measures import OVERLAP


def length(metres: float) -> str:
    """A length in a suitable unit."""
    size = abs(metres)
    if size < 1e-9:
        return "0 m"
    if size < 1e-4:
        return f"{metres * 1e6:.3g} µm"
    return f"{metres * 1e3:.3g} mm" if size < 0.1 else f"{metres:.4g} m"


def volume(cubic_metres: float) -> str:
    if abs(cubic_metres) < 0.1:
        return f"{cubic_metres * 1e6:.6g} cm³"
    return f"{cubic_metres:.6g} m³"


def surface(health: Health) -> str:
    """A phrase that states whether the triangles enclose a solid."""
    if health.is_solid:
        return "closed, a solid"
    defects = [
        f"{number} {words}"
        for number, words in (
            (health.non_finite, "triangles with NaN or infinite coordinates"),
            (health.collapsed, "degenerate triangles"),
            (health.repeated, "duplicate triangles"),
            (health.open_edges, "open edges"),
            (health.non_manifold_edges, "non-manifold edges"),
            (health.inconsistent_edges, "edges with inconsistent winding"),
            (health.inverted, "inverted bodies"),
            (health.doubled, "triangles of double-sided sheets without volume"),
        )
        if number
    ]
    if health.overlap > OVERLAP:
        defects.append(f"bodies that overlap: the volume is {100 * health.overlap:.0f} % too large")
    return ", ".join(defects) or "closed but flat: no volume"


def before_and_after(before: Health, after: Health) -> list[tuple[str, str, str]]:
    """A table of two states of a mesh, for `columns`."""
    closed = [("no", "yes")[health.is_closed] for health in (before, after)]
    return [
        ("", "before", "after"),
        ("triangles", str(before.faces), str(after.faces)),
        ("bodies", str(before.bodies), str(after.bodies)),
        ("closed", closed[0], closed[1]),
        ("volume", volume(before.volume), volume(after.volume)),
    ]


def distances(lost: float, gained: float) -> list[str]:
    """The deviation of the surface in both directions."""
    return [
        f"deviation, old surface to new  {length(lost)}",
        f"deviation, new surface to old  {length(gained)}",
    ]


def beyond(protrusion: float, missing: float) -> list[str]:
    """The distances by which shapes and mesh protrude from each other."""
    return [
        f"pieces stick out of the mesh by  {length(protrusion)}",
        f"mesh sticks out of the pieces by  {length(missing)}",
    ]


def columns(rows: Sequence[Sequence[str]]) -> list[str]:
    """Rows in columns, the first to the left and the others to the right."""
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    return [
        "  ".join(
            cell.ljust(width) if number == 0 else cell.rjust(width)
            for number, (cell, width) in enumerate(zip(row, widths, strict=True))
        ).rstrip()
        for row in rows
    ]
