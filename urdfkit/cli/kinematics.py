"""``urdfkit kinematics``: where links are, and how they move."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from math import degrees
from typing import Any

from urdfkit.cli import output
from urdfkit.cli.decorators import described, in_formats, limited, option
from urdfkit.cli.posing import posed, positions
from urdfkit.cli.robot import one_robot, robot
from urdfkit.core.spatial import Transform, to_rpy
from urdfkit.lint.context import Context
from urdfkit.robot.kinematics import frames, transform

VERSION = 1

#: Rows of a Jacobian: linear velocity in m/s or m/rad/s, then angular velocity.
_VELOCITY = ("vx", "vy", "vz", "wx", "wy", "wz")


@described("kinematics")
@one_robot
@posed
@option("--transform A B", "Pose of link B in the frame of link A.", to="ends", nargs=2)
@option("--jacobian LINK", "Jacobian of the origin of a link.")
@option("--mass-matrix", "The joint-space mass matrix.")
@in_formats("text", "json")
@limited
def command(
    asked: dict[str, Any],
    ends: tuple[str, str] | None,
    jacobian: str | None,
    mass_matrix: bool,
    form: str,
) -> int:
    """Compute link frames, transforms, Jacobian, mass matrix.

    Without further options, lists all link frames relative to their root. The Jacobian and the
    mass matrix have a column for each independent joint; they need Pinocchio.

    Exit codes: 0 done, 2 the file or the pose cannot be read, or a link is unknown.

    Examples:
        urdfkit kinematics robot.urdf.xacro --joint elbow=90deg
        urdfkit kinematics robot.urdf.xacro --transform base_link tool0
    """
    context = robot(asked)
    given = positions(context, asked)
    found: dict[str, Any] = {"version": VERSION, "pose": given}
    if not (ends or jacobian or mass_matrix):
        found["frames"] = frames(context.tree, given)
    if ends:
        found["transform"] = transform(context.tree, given, ends[1], ends[0])
        found["from"], found["to"] = ends
    if jacobian or mass_matrix:
        found |= _dynamics(context, given, jacobian, mass_matrix)
    roots = context.tree.root_of
    output.json_or_page(form, lambda: as_json(found, roots), render(found, roots))
    return 0


def _dynamics(
    context: Context, given: Mapping[str, float], link: str | None, mass_matrix: bool
) -> dict[str, Any]:
    """What Pinocchio computes.

    Raises:
        UrdfkitError: it is not installed, or cannot be asked this.
    """
    dynamics = context.dynamics
    found: dict[str, Any] = {"columns": list(dynamics.columns)}
    if link:
        found["link"] = link
        found["jacobian"] = dynamics.jacobian(link, given).tolist()
    if mass_matrix:
        found["mass_matrix"] = dynamics.mass_matrix(given).tolist()
    return found


def render(found: Mapping[str, Any], root_of: Mapping[str, str]) -> Iterator[str]:
    """The result as text; angles also in degrees."""
    where = "at the given pose" if found["pose"] else "all joints at zero"
    if "frames" in found:
        yield from _frames(found["frames"], root_of, where)
    if "transform" in found:
        frame = found["transform"]
        yield f"{found['to']} in {found['from']}, {where}"
        yield f"x y z in m:                 {_exactly(frame.position)}"
        yield f"roll pitch yaw in degrees:  {_exactly(_turn(frame))}"
        yield f"roll pitch yaw in rad:      {_exactly(to_rpy(frame.rotation))}"
    if "jacobian" in found:
        yield f"Jacobian of {found['link']}, {where}: a column in each line"
        columns = zip(found["columns"], zip(*found["jacobian"], strict=True), strict=True)
        head = " ".join(f"{name:>9}" for name in _VELOCITY)
        rows = [(name, _numbers(column)) for name, column in columns]
        yield from output.two_columns([("", head), *rows])
    if "mass_matrix" in found:
        yield f"mass matrix, {where}, in kg, kg m and kg·m²"
        yield from _matrix(found["mass_matrix"], found["columns"])


def _frames(
    found: Mapping[str, Transform], root_of: Mapping[str, str], where: str
) -> Iterator[str]:
    """The frames of each tree, relative to its root."""
    if not found:
        yield "no frames: no link is a root"
        return
    trees: dict[str, list[str]] = {}
    for name in found:
        trees.setdefault(root_of[name], []).append(name)
    for root, names in trees.items():
        head = f"frames in {root}, {where}: x y z in m, roll pitch yaw in degrees"
        yield from output.wrapped(head)
        yield from output.two_columns((name, _placed(found[name])) for name in names)


def _placed(frame: Transform) -> str:
    """A frame, rounded to 0.1 mm and 0.01 degrees, with the decimal points aligned."""
    position = " ".join(_fixed(value, 8, 4) for value in frame.position)
    return f"{position} {' '.join(_fixed(angle, 7, 2) for angle in _turn(frame))}"


def _fixed(value: float, width: int, digits: int) -> str:
    if abs(value) >= 10 ** (width - digits - 2):
        return f"{value:>{width}.2g}"
    return f"{round(value, digits) + 0.0:>{width}.{digits}f}"  # no negative zero


def _matrix(rows: Sequence[Sequence[float]], names: Sequence[str]) -> Iterator[str]:
    """A square matrix, in groups of columns that fit the terminal."""
    width = min(max(map(len, names), default=0), 20)
    count = max(1, (output.width() - width - 2) // 10)
    for start in range(0, len(names), count):
        if len(names) > count:
            columns = names[start : start + count]
            yield from output.wrapped(f"columns {', '.join(columns)}")
        cut = (_numbers(row[start : start + count]) for row in rows)
        yield from output.two_columns(zip(names, cut, strict=True))


def _turn(frame: Transform) -> list[float]:
    return [degrees(angle) for angle in to_rpy(frame.rotation)]


def _exactly(values: Iterable[float]) -> str:
    return " ".join(f"{0.0 if abs(value) < 1e-12 else value:>12.7g}" for value in values)


def _numbers(values: Iterable[float]) -> str:
    return output.aligned(values, noise=1e-12)


def as_json(found: Mapping[str, Any], root_of: Mapping[str, str]) -> dict[str, Any]:
    """The result for JSON, in m and rad; rotations are three rows."""
    document = dict(found)
    if "frames" in found:
        document["frames"] = {
            name: {"root": root_of[name], **_frame(frame)}
            for name, frame in found["frames"].items()
        }
    if "transform" in found:
        document["transform"] = _frame(found["transform"])
    return document


def _frame(frame: Transform) -> dict[str, Any]:
    return {
        "position": list(frame.position),
        "rpy": [angle + 0.0 for angle in to_rpy(frame.rotation)],  # no negative zero
        "rotation": [list(row) for row in frame.rotation],
    }
