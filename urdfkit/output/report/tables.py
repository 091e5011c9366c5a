"""The parts of a report that are computed from the robot: rows of plain values."""

from typing import Any

from urdfkit.errors import MissingLibrary, Unavailable
from urdfkit.lint.context import Context
from urdfkit.output.overview import summarise
from urdfkit.robot.inertia import principal_moments
from urdfkit.robot.joint import Joint
from urdfkit.robot.link import Link, Shape
from urdfkit.text.source import Span, shown

Row = dict[str, Any]


def robot(context: Context) -> Row:
    """Properties of the whole robot with all joints at zero, in the frame of its root."""
    model, tree = context.model, context.tree
    overview = summarise(context)
    whole, box = overview.weight.whole.properties, overview.shapes.robot_box
    return {
        "name": model.name,
        "links": len(model.links),
        "joints": len(model.joints),
        "degrees_of_freedom": model.degrees_of_freedom,
        "roots": [root.name for root in tree.roots],
        "mass": model.mass,
        "center": list(whole.center) if whole else None,
        "visuals": sum(len(link.visuals) for link in model.links),
        "size": list(box.edges) if box else None,
        "reach": overview.reach.distance if overview.reach else None,
        "collisions": sum(len(link.collisions) for link in model.links),
    }


def links(context: Context) -> list[Row]:
    """Each link with its mass, centre of mass and principal moments."""
    total = context.model.mass
    return [_link(link, total) for link in context.model.links]


def _link(link: Link, total: float) -> Row:
    inertial = link.inertial
    tensor = inertial.tensor.value if inertial and inertial.tensor else None
    return {
        "name": link.name,
        "mass": inertial.mass.value if inertial and inertial.mass else None,
        "share": link.mass / total if total > 0 else 0.0,
        "center": list(inertial.origin.position) if inertial else None,
        "moments": list(principal_moments(tensor)) if tensor else None,
        "inertia": tensor._asdict() if tensor else None,
        "visuals": [_shape(body.shape) for body in link.visuals],
        "collisions": [_shape(body.shape) for body in link.collisions],
        **_place(link.at.span),
    }


def _shape(shape: Shape | None) -> str:
    """File name of a mesh, or kind of another shape."""
    if shape is None:
        return ""
    return shape.filename.value if shape.filename else shape.kind


def _place(span: Span) -> Row:
    return {"path": shown(span.source.path), "line": span.line, "column": span.column}


def joints(context: Context) -> list[Row]:
    """Each joint with its type, links, axis, limits and mimicked joint."""
    return [_joint(joint) for joint in context.model.joints]


def _joint(joint: Joint) -> Row:
    limits = {
        key: placed.value if joint.limit and (placed := getattr(joint.limit, key)) else None
        for key in ("lower", "upper", "effort", "velocity")
    }
    mimic = None
    if joint.mimic and joint.leader:
        mimic = {
            "joint": joint.leader,
            "multiplier": joint.mimic.multiplier,
            "offset": joint.mimic.offset,
        }
    return {
        "name": joint.name,
        "type": joint.kind,
        "parent": joint.parent_name,
        "child": joint.child_name,
        "axis": list(joint.axis.value) if joint.axis else None,
        **limits,
        "mimic": mimic,
        **_place(joint.at.span),
    }


def gazebo(context: Context) -> Row:
    """The result of the conversion to SDF: for each URDF link, and the remaining links."""
    conversion = context.gazebo
    results = {
        link.name: _conversion_result(link.name, conversion.survivor, conversion.dropped)
        for link in conversion.model.links
    }
    return {
        "converter": conversion.converter.name,
        "results": [{"link": name, **result} for name, result in results.items()],
        "links": [
            {
                "name": link.name,
                "mass": link.properties.mass,
                "center": list(link.properties.center),
                "merged": list(link.body.names[1:]),
            }
            for link in conversion.links
        ],
        "joints": len(conversion.joints) + len(conversion.added_joints),
        "added": [link.get("name") for link in conversion.added_links],
    }


def _conversion_result(name: str, survivor: dict[str, str], dropped: dict[str, str]) -> Row:
    if name in dropped:
        return {"result": "dropped", "into": "", "reason": dropped[name]}
    if name not in survivor:
        return {"result": "not converted", "into": "", "reason": ""}
    into = survivor[name]
    result = "kept" if into == name else "merged"
    return {"result": result, "into": into if into != name else "", "reason": ""}


def meshes(context: Context) -> list[Row]:
    """Each mesh reference of the robot, with path and properties of the file."""
    counts = _triangles(context)
    rows = []
    for mesh in context.files.meshes:
        facts = mesh.facts
        rows.append(
            {
                "link": mesh.link.name,
                "role": mesh.role,
                "name": mesh.at.value,
                "path": shown(mesh.located.path) if mesh.located.path else None,
                "format": facts.format if facts else "",
                "size": facts.size if facts else None,
                "triangles": counts.get(mesh.at.value),
                "defect": facts.defect.reason if facts and facts.defect else "",
            }
        )
    return rows


def _triangles(context: Context) -> dict[str, int]:
    """Number of triangles of mesh files, by the file name in the robot."""
    counts: dict[str, int] = {}
    for shape in context.model.shapes:
        if shape.filename and shape.filename.value not in counts:
            try:
                mesh = context.meshes.mesh(shape)
            except (ImportError, MissingLibrary, Unavailable):
                return {}
            if mesh is not None:
                counts[shape.filename.value] = sum(len(part.faces) for part in mesh.parts)
    return counts
