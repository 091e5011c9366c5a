"""``urdfkit mesh hull``: the convex hull of a mesh."""

from urdfkit.cli import output
from urdfkit.cli.decorators import described, limited
from urdfkit.cli.mesh import tables
from urdfkit.cli.mesh.saving import save, writes
from urdfkit.cli.progress import working
from urdfkit.mesh.convex_hull import hull
from urdfkit.mesh.health import examine_mesh
from urdfkit.mesh.io.load import load
from urdfkit.mesh.transforms import in_metres


@described("hull")
@writes
@limited
def command(file: str, path: str | None) -> int:
    """Compute the convex hull of a mesh.

    Exit codes: 0 done, 2 usage or input error.

    Examples:
        urdfkit mesh hull arm.dae -o arm_hull.stl
    """
    with working():
        mesh = in_metres(load(file))
        hull_mesh = hull(mesh)
        rows = tables.before_and_after(examine_mesh(mesh), examine_mesh(hull_mesh))
    output.page([*tables.columns(rows), *save(hull_mesh, path)])
    return 0
