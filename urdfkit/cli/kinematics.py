"""``urdfkit kinematics``: link frames, transforms, Jacobian, mass matrix."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from math import degrees
from typing import Any

from urdfkit.cli import output
from urdfkit.cli.decorators import described, in_formats, limited, option
from urdfkit.cli.posing import posed, positions
from urdfkit.cli.robot import one_robot, robot
from urdfkit.core.grouping import by_key
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
    inputs: dict[str, Any],
    ends: tuple[str, str] | None,
    jacobian: str | None,
    mass_matrix: bool,
    format: str,
) -> int:
    """Compute link frames, transforms, Jacobian, mass matrix.

    Without further options, lists all link frames relative to their root. The Jacobian and the
    mass matrix have a column for each independent joint; they need Pinocchio.

    Exit codes: 0 done, 2 the file or the pose cannot be read, or a link is unknown.

    Examples:
        urdfkit kinematics robot.urdf.xacro --joint elbow=90deg
        urdfkit kinematics robot.urdf.xacro --transform base_link tool0
    """
    context = robot(inputs)
    pose = positions(context, inputs)
    result: dict[str, Any] = {"version": VERSION, "pose": pose}
    if not (ends or jacobian or mass_matrix):
        result["frames"] = frames(context.tree, pose)
    if ends:
        result["transform"] = transform(context.tree, pose, ends[1], ends[0])
        result["from"], result["to"] = ends
    if jacobian or mass_matrix:
        result |= _dynamics(context, pose, jacobian, mass_matrix)
    roots = context.tree.root_of
    output.json_or_page(format, lambda: as_json(result, roots), render(result, roots))
    return 0


def _dynamics(
    context: Context, pose: Mapping[str, float], link: str | None, mass_matrix: bool
) -> dict[str, Any]:
    """Jacobian and mass matrix, computed by Pinocchio.

    Raises:
        UrdfkitError: Pinocchio is not installed, or the link is unknown.
    """
    dynamics = context.dynamics
    result: dict[str, Any] = {"columns": list(dynamics.columns)}
    if link:
        result["link"] = link
        result["jacobian"] = dynamics.jacobian(link, pose).tolist()
    if mass_matrix:
        result["mass_matrix"] = dynamics.mass_matrix(pose).tolist()
    return result


def render(result: Mapping[str, Any], root_of: Mapping[str, str]) -> Iterator[str]:
    """The result as text; angles also in degrees."""
    pose_note = "at the given pose" if result["pose"] else "all joints at zero"
    if "frames" in result:
        yield from _frames(result["frames"], root_of, pose_note)
    if "transform" in result:
        frame = result["transform"]
        yield f"{result['to']} in {result['from']}, {pose_note}"
        yield f"x y z in m:                 {_exactly(frame.position)}"
        yield f"roll pitch yaw in degrees:  {_exactly(_turn(frame))}"
        yield f"roll pitch yaw in rad:      {_exactly(to_rpy(frame.rotation))}"
    if "jacobian" in result:
        yield f"Jacobian of {result['link']}, {pose_note}: a column in each line"
        columns = zip(result["columns"], zip(*result["jacobian"], strict=True), strict=True)
        head = " ".join(f"{name:>9}" for name in _VELOCITY)
        rows = [(name, _numbers(column)) for name, column in columns]
        yield from output.two_columns([("", head), *rows])
    if "mass_matrix" in result:
        yield f"mass matrix, {pose_note}, in kg, kg·m and kg·m²"
        yield from _matrix(result["mass_matrix"], result["columns"])


def _frames(
    frames_by_link: Mapping[str, Transform], root_of: Mapping[str, str], pose_note: str
) -> Iterator[str]:
    """The frames of each tree, relative to its root."""
    if not frames_by_link:
        yield "no frames: no link is a root"
        return
    trees = by_key((root_of[name], name) for name in frames_by_link)
    for root, names in trees.items():
        head = f"frames in {root}, {pose_note}: x y z in m, roll pitch yaw in degrees"
        yield from output.wrapped(head)
        yield from output.two_columns((name, _placed(frames_by_link[name])) for name in names)


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


def as_json(result: Mapping[str, Any], root_of: Mapping[str, str]) -> dict[str, Any]:
    """The result for JSON, in m and rad; rotations are three rows."""
    document = dict(result)
    if "frames" in result:
        document["frames"] = {
            name: {"root": root_of[name], **_frame(frame)}
            for name, frame in result["frames"].items()
        }
    if "transform" in result:
        document["transform"] = _frame(result["transform"])
    return document


def _frame(frame: Transform) -> dict[str, Any]:
    return {
        "position": list(frame.position),
        "rpy": [angle + 0.0 for angle in to_rpy(frame.rotation)],  # no negative zero
        "rotation": [list(row) for row in frame.rotation],
    }
