"""``urdfkit mesh capsules``: one or a few capsules for each link of a robot."""

from typing import Any

from urdfkit.cli.decorators import described, limited
from urdfkit.cli.mesh.covering import covering, write
from urdfkit.cli.progress import progress_bar
from urdfkit.cli.robot import one_robot, robot
from urdfkit.output.covers import fit_capsules
from urdfkit.output.covers.capsule_formats import FORMATS


@described("capsules")
@one_robot
@covering(
    "capsules",
    FORMATS,
    most=30,
    margin=0.02,
    margin_help="A link whose capsules protrude by more (p95) gets another one, if it helps.",
)
@limited
def command(inputs: dict[str, Any], out: str | None, format: str, **options: Any) -> int:
    """Cover each link of a robot with one capsule, or a few.

    <capsule> is URDF 1.1: Pinocchio, MoveIt and RViz read it with urdfdom 6, MuJoCo, Drake and
    PyBullet in any case. urdf-1.0 is for others: a cylinder and two spheres for each capsule.

    Exit codes: 0 done, 1 some geometry is omitted, 2 usage or input error.

    Examples:
        urdfkit mesh capsules robot.urdf.xacro -o capsules.urdf
        urdfkit mesh capsules robot.urdf.xacro --format urdf-1.0 -o capsules.urdf
        urdfkit mesh capsules robot.urdf --format json
    """
    context = robot(inputs)
    with progress_bar() as bar:
        found = fit_capsules(context, progress=bar, **options)
    return write("capsules", context, found, FORMATS, format, out)
