"""Robots that cannot be converted to SDF: Gazebo rejects or misreads them."""

from collections.abc import Iterator

from urdfkit.errors import UrdfkitError
from urdfkit.lint.context import Context
from urdfkit.lint.runner import run_rules
from urdfkit.robot.model import Link
from urdfkit.ros.gazebo.conversion import JOINT_TYPES, SdfConversion
from urdfkit.ros.gazebo.rejection import CODES, IN_JOINTS, rejections
from urdfkit.text.diagnostic import Severity
from urdfkit.text.document import Element
from urdfkit.text.source import Span

#: Shapes that urdfdom reads, and the attribute that each shape requires.
_SHAPES = {"box": "size", "cylinder": "radius", "sphere": "radius", "mesh": "filename"}

#: Greatest depth of nested elements in tinyxml2, which sdformat uses.
_MAX_DEPTH = 500


def require(robot: Context, conversion: SdfConversion) -> None:
    """Raise an error at the first part that cannot be converted to SDF.

    Raises:
        UrdfkitError: Gazebo rejects the robot, or loses a part of it.
    """
    diagnostics = run_rules(robot, sorted(CODES)).diagnostics
    for rejection in rejections(diagnostics, conversion):
        hint = f"; see: urdfkit explain {rejection.code}" if rejection.code else ""
        raise UrdfkitError(
            f"{rejection.span}: {rejection.reader} rejects the robot: {rejection.message}{hint}"
        )
    for diagnostic in diagnostics:
        if diagnostic.code in IN_JOINTS and diagnostic.severity is Severity.ERROR:
            raise UrdfkitError(
                f"{diagnostic.span}: {diagnostic.message}: Gazebo loses this part of the robot; "
                f"see: urdfkit explain {diagnostic.code}"
            )
    for span, message in _defects(conversion):
        raise UrdfkitError(f"{span}: {message}")


def _defects(conversion: SdfConversion) -> Iterator[tuple[Span, str]]:
    model = conversion.model
    if not model.name:
        yield model.root.span, "gz rejects the robot: it has no name; give <robot> one"
    deep = _too_deep(model.root)
    if deep is not None:
        message = f"Gazebo reads at most {_MAX_DEPTH} elements within one another; remove some"
        yield deep.span, message
    for link in model.links:
        yield from _of_link(link)
    for simulated in conversion.links:
        joint = simulated.body.joint
        if joint is not None and joint.kind not in JOINT_TYPES:
            message = f"gz rejects the robot: SDF is written without {joint.kind} joints"
            yield joint.at.span, f"{message}; take another type"
        leader = joint.mimic.joint if joint and joint.mimic else None
        if leader is not None and joint is not None and leader.value == joint.name:
            yield leader.span, "gz rejects the robot: the joint follows itself; name another one"


def _too_deep(root: Element) -> Element | None:
    """The first element that is nested too deeply."""
    stack = [(root, 1)]
    while stack:
        element, depth = stack.pop()
        if depth > _MAX_DEPTH:
            return element
        stack += [(child, depth + 1) for child in reversed(element.children)]
    return None


def _of_link(link: Link) -> Iterator[tuple[Span, str]]:
    inertial = link.inertial
    if inertial is not None and (inertial.mass is None or inertial.tensor is None):
        yield (
            inertial.at.span,
            f"link '{link.name}': <inertial> needs <mass> and <inertia>; add them",
        )
    for body in (*link.collisions, *link.visuals):
        shape = body.shape
        what = f"<{body.at.tag}> of link '{link.name}'"
        if shape is None:
            yield body.at.span, f"{what} has no shape; add one, or remove it"
        elif shape.kind not in _SHAPES:
            yield shape.at.span, f"{what}: Gazebo reads no <{shape.kind}> of a URDF; take a mesh"
        elif getattr(shape, _SHAPES[shape.kind]) is None:
            yield shape.at.span, f"{what}: <{shape.kind}> needs {_SHAPES[shape.kind]}; add it"
