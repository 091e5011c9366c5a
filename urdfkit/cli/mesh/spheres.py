"""``urdfkit mesh spheres``: spheres for motion planners in place of collision geometry."""

from typing import Any

from urdfkit.cli.decorators import described, limited
from urdfkit.cli.mesh.covering import covering, write
from urdfkit.cli.progress import progress_bar
from urdfkit.cli.robot import one_robot, robot
from urdfkit.output.covers import fit_spheres
from urdfkit.output.covers.sphere_formats import FORMATS


@described("spheres")
@one_robot
@covering(
    "spheres",
    FORMATS,
    most=100,
    margin=0.01,
    margin_help="Approximate distance that a sphere may protrude, if --most allows it.",
)
@limited
def command(inputs: dict[str, Any], out: str | None, format: str, **options: Any) -> int:
    """Cover the links of a robot with spheres, for motion planners.

    cuRobo's YAML and XRDF also list pairs of links that need no check for self-collision; URDF has
    spheres as collisions. The table is measured with samples that were not used for the fit.

    Exit codes: 0 done, 1 some geometry is omitted, 2 usage or input error.

    Examples:
        urdfkit mesh spheres robot.urdf.xacro -o robot.yml
        urdfkit mesh spheres robot.urdf.xacro --format xrdf -o robot.xrdf
        urdfkit mesh spheres robot.urdf --format urdf -o spheres.urdf --most 60
    """
    context = robot(inputs)
    with progress_bar() as bar:
        found = fit_spheres(context, progress=bar, **options)
    return write("spheres", context, found, FORMATS, format, out)
