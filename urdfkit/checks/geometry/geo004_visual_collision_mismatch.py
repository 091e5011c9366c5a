"""The collision geometry of a link does not match the visual geometry.

The rule compares the bounding box of all collisions of a link with that of all visuals.

- The sizes differ by a factor of 5 in every direction; for two meshes, by 1.5 if the factor is the
  same in all directions. One of the two has the wrong unit: a mesh in millimetres or inches without
  its `scale` (unless MSH012 reports it), a mesh with an unnecessary scale, a radius in centimetres.
  An info for smaller primitives in place of a mesh, if the factor is that of no such mistake.
- One is rotated: after a quarter turn about the origin of one, the boxes would nearly coincide.
  Often a mesh was exported with other axes, or an `rpy` was written for the visual only. Meshes
  that programs rotate differently (MSH013) are not reported.
- The boxes have at most a third of their volume in common, for example because only the visual has
  the `<origin>` at half the height: visual and collision do not share it. A larger or smaller
  collision around the same centre is not reported, nor is a primitive that replaces a part of a
  mesh, or encloses one of several visuals.
- A link has the visual mesh of its left or right counterpart, no link uses the mesh file of its own
  side, and other pairs have a mesh for each side; or one of at least four fingers has the mesh of
  another finger. Or its collision is named after the other side than its visual, and no link uses
  the file of its own side.
- Links have one mesh for visual and collision, but one link has it at two scales, or collides with
  the mesh of another link; or one link alone has a mesh and its collision mesh at two places.
- The collision of one of at least four legs or wheels has another size than those of the others,
  and their visuals have one size.
- A radius is exactly 10, 100 or 1000 times that of the same shape in the other. An info is exactly
  twice, or about twice that of a mesh: a diameter.

Wheels sink into the floor or hover, grippers close without contact, and MoveIt avoids free space
and plans through the real part.

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
    measured: of 579 public robots, nine differ in size, eight of them by a scale
"""

import os
from math import inf

from urdfkit.checks.geometry.link_meshes import mesh_of_another_link, other_origin, other_scale
from urdfkit.checks.geometry.odd_legs import odd_legs
from urdfkit.checks.geometry.other_side import (
    MeshOfOtherSide,
    collisions_of_the_other_side,
    meshes_of_another_finger,
    meshes_of_the_other_side,
)
from urdfkit.checks.geometry.radii import different_radii, radius_of_mesh
from urdfkit.core.spatial import Z_AXIS, Transform, Vector, cross, dot, length, minus, rotate
from urdfkit.core.words import rounded
from urdfkit.lint.rules import Confidence, Context, Finding, Findings, Fix, Related, Severity, rule
from urdfkit.robot.assets.collision_mismatches import Mismatch, VisualCollisionPairs
from urdfkit.robot.assets.mesh_defects import MeshDefect
from urdfkit.robot.assets.visual_collision import LEAST_OVERLAP, VisualCollisionPair
from urdfkit.robot.joint import Joint
from urdfkit.robot.link import Body, Link
from urdfkit.robot.samples import collision_xml, link_xml, visual_xml
from urdfkit.robot.shapes import BoundingBox, LinkSolid
from urdfkit.text.diagnostic import Edit
from urdfkit.text.document import Element
from urdfkit.text.editing.edits import insert_first, remove_element

_BOX, _ORIGIN = '<box size="0.2 0.3 0.1"/>', '<origin rpy="0 0 1.5707963267948966" xyz="0 0 0.05"/>'
BAD = link_xml("base", visual_xml(_BOX, _ORIGIN), collision_xml(_BOX))
FIXED = GOOD = BAD.replace("<collision>", f"<collision>\n    {_ORIGIN}")

#: Causes of a wrong size, by the factor.
_UNIT_MISTAKES = {
    1000.0: "millimetres read as metres",
    100.0: "centimetres read as metres",
    39.37: "inches read as metres",
    25.4: "inches read as millimetres, or the reverse",
    10.0: "a decimal point",
}
#: Distance as a multiple of the length, above which either body may be misplaced.
_MAX_RELATIVE_SHIFT = 10.0

#: Distance of two centres as a part of the length, below which they are equal.
_SAME_CENTER = 0.01

#: Sine of the angle up to which two axes are parallel.
_PARALLEL = 0.1

#: Relative tolerance of a factor of units: visual and collision are rarely equal.
_UNIT_TOLERANCE = 1.08


@rule(
    Severity.WARNING,
    confidence=Confidence.INFERRED,
    help="compare both in RViz, and correct the one that is wrong",
)
def check(context: Context) -> Findings:
    model, files = context.model, context.files
    compared = VisualCollisionPairs(model, context.mesh_solid, files.has_ambiguous_axes)
    for pair in compared.mismatches.get(Mismatch.APART, ()):
        yield _apart(pair, context, compared.of_another_link(pair))
    for pair in compared.mismatches.get(Mismatch.SIZE, ()):
        wrong = pair.unusual(compared.span)
        if not _is_in_millimetres(wrong, context):
            yield _of_size(pair, wrong)
    for pair in compared.mismatches.get(Mismatch.ROTATION, ()):
        yield _rotated(pair, context, compared.of_another_link(pair))
    yield from other_scale(context)
    reported = {pair.link.name for of_kind in compared.mismatches.values() for pair in of_kind}
    yield from mesh_of_another_link(context, reported)
    yield from other_origin(context, reported)
    yield from odd_legs(context, reported)
    yield from different_radii(context)
    for pair in compared.each():
        yield from radius_of_mesh(pair)
    for copied in (*meshes_of_the_other_side(context), *meshes_of_another_finger(context)):
        side = copied.correct.link.name
        what = f"the visual is the mesh of its counterpart '{side}'"
        yield _copied(copied, what, f"the mesh of '{side}'")
    for copied in collisions_of_the_other_side(context):
        seen, used = (os.path.basename(mesh.at.value) for mesh in (copied.correct, copied.wrong))
        what = f"the collision '{used}' is of the other side than the visual '{seen}'"
        yield _copied(copied, what, "the visual")


def _copied(mesh: MeshOfOtherSide, what: str, note: str) -> Finding:
    return Finding(
        mesh.wrong.at,
        f"link '{mesh.wrong.link.name}': {what}, and no link uses '{mesh.unused}'",
        f"write the path of '{mesh.unused}'",
        related=(Related(mesh.correct.at.span, note),),
    )


def _apart(
    pair: VisualCollisionPair, context: Context, foreign: tuple[Body, str] | None
) -> Finding:
    link = pair.link
    wrong, right, is_known = _misplaced(pair, context)
    difference = _difference(link) if pair.has_one_shape else ""
    if foreign:
        difference, is_known = _of_another_link(*foreign), False
        if wrong is not foreign[0]:
            wrong, right = right, wrong
    is_known = is_known and bool(difference) and not _is_far(pair)
    return Finding(
        wrong.at,
        f"link '{link.name}': the bounding boxes of collision and visual have only "
        f"{pair.overlap:.0%} of their volume in common, less than {LEAST_OVERLAP:.0%}{difference}",
        f"name the mesh of '{link.name}'" if foreign else _help(pair, wrong, right),
        _fix(wrong.at, right.at) if is_known else None,
        (Related(right.at.span, f"the {right.at.tag}"),),
        weight=1 - pair.overlap,
        group_key="moved" if difference else "apart",
    )


def _is_far(pair: VisualCollisionPair) -> bool:
    shift = minus(pair.visual.bounds.center, pair.collision.bounds.center)
    return length(shift) > _MAX_RELATIVE_SHIFT * max(pair.visual.bounds.edges)


def _help(pair: VisualCollisionPair, wrong: Body, right: Body) -> str:
    """Help: another sign, the origin of the other body, or a distance if both origins are equal."""
    if axis := pair.mirrored_axis:
        return f"write the other sign for {axis} of the collision's <origin>"
    if wrong.origin != right.origin:
        return f"give the {wrong.at.tag} the <origin> of the {right.at.tag}"
    shift = minus(pair.visual.bounds.center, pair.collision.bounds.center)
    if length(shift) < _SAME_CENTER * max(pair.visual.bounds.edges):
        return "compare the sizes of the two: they have the same centre"
    return f"add {rounded(shift, 4)} to the <origin> of the collision, to center it on the visual"


def _is_in_millimetres(body: Body, context: Context) -> bool:
    """True for a mesh that MSH012 reports, with a fix."""
    uses = context.measured.defects.get(MeshDefect.MILLIMETRES, ())
    return body.is_mesh and any(use.shape is body.shape for use in uses)


def _of_size(pair: VisualCollisionPair, wrong: Body) -> Finding:
    assert pair.factor
    larger, smaller = ("visual", "collision") if pair.factor > 1 else ("collision", "visual")
    factor = max(pair.factor, 1 / pair.factor)
    is_visual = wrong is pair.link.visuals[0]
    other = pair.link.collisions[0] if is_visual else pair.link.visuals[0]
    times = f"{factor:.3g}" if factor < 999.5 else f"{factor:.0f}"
    mistakes = (
        f", as by {text}"
        for unit, text in _UNIT_MISTAKES.items()
        if unit / _UNIT_TOLERANCE < factor < unit * _UNIT_TOLERANCE
    )
    mistake = next(mistakes, "")
    # A primitive without a mistake of units may be small on purpose, so that nothing touches it.
    is_stand_in = larger == "visual" and not mistake and _replaces_mesh(pair.link)
    return Finding(
        wrong.shape.at if wrong.shape else wrong.at,
        f"link '{pair.link.name}': the {larger} is {times} times as large as the {smaller}"
        f"{mistake}: {_edges(pair.visual.bounds)} (visual), {_edges(pair.collision.bounds)} "
        "(collision)",
        "correct the scale or the size of the one that is wrong",
        related=(Related(other.at.span, "the collision" if is_visual else "the visual"),),
        weight=factor,
        severity=Severity.INFO if is_stand_in else None,
    )


def _replaces_mesh(link: Link) -> bool:
    """True for primitives as collisions of visuals that are meshes."""
    visuals, collisions = (
        {body.shape.kind for body in bodies if body.shape}
        for bodies in (link.visuals, link.collisions)
    )
    return visuals == {"mesh"} and "mesh" not in collisions


def _of_another_link(body: Body, link: str) -> str:
    return f"; the {body.at.tag} is the mesh of '{link}'"


def _rotated(
    pair: VisualCollisionPair, context: Context, foreign: tuple[Body, str] | None
) -> Finding:
    joints = context.tree.parents.get(pair.link.name, [])
    bodies = (*pair.link.collisions, *pair.link.visuals)
    across = [body for body in bodies if any(_lies_across(body, joint) for joint in joints)]
    turn = pair.best_turn(across) or pair.turn
    assert turn is not None
    is_visual = turn.body in pair.link.visuals
    role, other = ("visual", "collision") if is_visual else ("collision", "visual")
    others = pair.link.collisions if is_visual else pair.link.visuals
    rpy = rounded(turn.rpy, 4)
    return Finding(
        turn.body.at.child_or_self("origin"),
        f"link '{pair.link.name}': the bounding boxes of visual and collision have "
        f'{pair.overlap:.0%} of their volume in common; with rpy="{rpy}" for the {role} it '
        f"would be {turn.overlap:.0%}" + (_of_another_link(*foreign) if foreign else ""),
        f"name the mesh of '{pair.link.name}', or correct the <origin>" if foreign else "",
        related=(Related(others[0].at.span, f"the {other}"),),
        weight=turn.overlap - pair.overlap,
    )


def _edges(box: BoundingBox) -> str:
    return " x ".join(f"{edge:.3g}" for edge in box.edges) + " m"


def _misplaced(pair: VisualCollisionPair, context: Context) -> tuple[Body, Body, bool]:
    """The body that is probably misplaced, the other body, and whether nothing contradicts that.

    The misplaced body is the collision, unless the inertia has the same origin, and the joint
    another one, which the two would repeat, or unless the centre of mass is that of the collision.
    If the tensor fits the collision and not the visual,
    either the tensor was not updated, like the collision, or the visual is wrong: only a cylinder
    on a joint shows which, as it turns about its own axis.
    """
    link = pair.link
    collision, visual = link.collisions[0], link.visuals[0]
    inertial = link.inertial.origin if link.inertial else Transform()
    joints = context.tree.parents.get(link.name, [])  # none without a name
    is_of_joint = any(joint.origin == collision.origin for joint in joints)
    if pair.has_one_shape and any(inertial.position) and not is_of_joint:
        gaps = [_distance(solid, inertial.position) for solid in (pair.collision, pair.visual)]
        if gaps[0] < _SAME_CENTER * gaps[1]:
            return visual, collision, True
    if Transform() != inertial == collision.origin != visual.origin and not is_of_joint:
        return visual, collision, True
    inertia = context.masses.by_name.get(link.name)
    if inertia is None or not inertia.is_of(pair.collision) or inertia.is_of(pair.visual):
        return collision, visual, True
    if any(_turns_about_own_axis(collision, joint) for joint in joints):
        return visual, collision, True
    return collision, visual, any(_turns_about_own_axis(visual, joint) for joint in joints)


def _distance(solid: LinkSolid, point: Vector) -> float:
    """Distance of the centre of mass of a solid from a point, in m; none without a volume."""
    center = solid.properties(1).center if solid.volume > 0 else None
    return inf if center is None else length(minus(center, point))


def _lies_across(body: Body, joint: Joint) -> bool:
    """True for a cylinder that is turned without end about an axis across its own."""
    is_cylinder = body.shape is not None and body.shape.kind == "cylinder"
    if not is_cylinder or joint.kind != "continuous" or joint.axis is None:
        return False
    axis, own = joint.axis.value, rotate(body.origin.rotation, Z_AXIS)
    return abs(dot(axis, own)) < _PARALLEL * length(axis)


def _turns_about_own_axis(body: Body, joint: Joint) -> bool:
    """True for a cylinder along the axis of its joint."""
    if body.shape is None or body.shape.kind != "cylinder" or joint.axis is None:
        return False
    axis, own = joint.axis.value, rotate(body.origin.rotation, Z_AXIS)
    return joint.kind != "fixed" and length(cross(axis, own)) < _PARALLEL * length(axis)


def _fix(wrong: Element, right: Element) -> Fix | None:
    """Gives one body the origin of the other, which has the same shape."""
    if wrong.frame is not right.frame:  # expressions have other values in another macro call
        return None
    old, new = wrong.child("origin"), right.child("origin")
    title = f"give the {wrong.tag} the <origin> of the {right.tag}"
    if new is None:
        return Fix(f"remove the <origin> of the {wrong.tag}", remove_element(old)) if old else None
    if old is None:
        return Fix(title, insert_first(wrong, (new.tag_at.whole_span.text,)))
    return Fix(title, (Edit(old.tag_at.whole_span, new.tag_at.whole_span.text),))


def _difference(link: Link) -> str:
    """The difference between the origins of two equal shapes."""
    (collision,), (visual,) = link.collisions, link.visuals
    shift = [b - a for a, b in zip(collision.origin.position, visual.origin.position, strict=True)]
    parts = []
    if collision.origin.rotation != visual.origin.rotation:
        parts.append("rotated")
    if any(shift):
        parts.append("moved by {:.3g} {:.3g} {:.3g} m".format(*shift))
    return f"; the visual is the same shape, {' and '.join(parts)}"
