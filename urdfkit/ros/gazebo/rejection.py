"""Defects for which libsdformat rejects the whole robot, so that Gazebo does not load it.

Source: libsdformat 12.3 on robots with one defect each. It reads URDF with urdfdom: a defect in a
joint rejects the robot, a defect in a link loses only that part of the link; one in a visual loses
the visuals after it and all collisions of the link, too.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from urdfkit.core.record import Record
from urdfkit.robot.inertia import principal_moments
from urdfkit.robot.joint import Joint
from urdfkit.ros.gazebo import REJECTED, REJECTED_BY_GZ
from urdfkit.ros.gazebo.conversion import SdfConversion
from urdfkit.text.diagnostic import Diagnostic, Severity
from urdfkit.text.source import Span

CONVERTER_FAILS = "converter ends with an exception"
#: Relative tolerance of moments of inertia for numbers that are rounded as text.
_SLACK = 1e-6

#: Rules whose findings reject the robot.
ALWAYS = frozenset("JNT001 JNT002 NAM001 REF001 TRE001 TRE002 TRE003 URD015".split())
#: Rules with some findings that reject the robot, recognised by their messages.
SOMETIMES = frozenset("GAZ004 GAZ010 GAZ040 GAZ047".split())
#: Rules whose findings reject the robot if they concern a joint.
IN_JOINTS = frozenset("URD003 URD004 URD005".split())
#: Rules whose errors reject the robot if they concern its root element.
OF_ROOT = frozenset("URD003 URD011".split())
#: Rules of which only errors reject the robot.
_ONLY_ERRORS = frozenset(("JNT002", "JNT006", "NAM001"))
#: Rules whose findings the SDF parser of gz rejects after the conversion, not Gazebo Classic's.
BY_GZ = frozenset(("JNT006",))

CODES = ALWAYS | SOMETIMES | IN_JOINTS | OF_ROOT | BY_GZ


class Rejection(Record):
    """A reason why a robot is rejected."""

    reader: str  # ``libsdformat``, which converts for every Gazebo, or ``gz``
    code: str  # of the rule that reports it; empty without a rule
    message: str
    span: Span  # source location


def rejections(diagnostics: Iterable[Diagnostic], conversion: SdfConversion) -> list[Rejection]:
    """Reasons why a robot is rejected; empty if it is not.

    Args:
        diagnostics: of the rules in `CODES`, at least.
    """
    reasons = list(_reported(diagnostics))
    if not reasons and not (conversion.links or conversion.added_links):
        reasons.append(_of_nothing(conversion))
    reasons += _of_names(conversion)
    reasons += _of_frames(conversion)
    reasons += _of_joints(conversion)
    reasons += _of_inertia(conversion)
    reasons += _of_masses(conversion)
    return reasons


def _reported(diagnostics: Iterable[Diagnostic]) -> Iterator[Rejection]:
    for diagnostic in diagnostics:
        code, is_error = diagnostic.code, diagnostic.severity is Severity.ERROR
        if code in _ONLY_ERRORS and not is_error:
            continue
        message = diagnostic.message if code in SOMETIMES else ""
        elements = [call.element for call in diagnostic.calls]
        in_joint = any(element.startswith("joint/") for element in elements)
        of_root = is_error and any("/" not in element for element in elements)
        is_of_mimic = any("/mimic" in element for element in elements)
        if (
            (code in ALWAYS and not is_of_mimic)
            or (code in IN_JOINTS and in_joint)
            or (code in OF_ROOT and of_root)
            or REJECTED in message
            or CONVERTER_FAILS in message
        ):
            yield Rejection("libsdformat", code, diagnostic.message, diagnostic.span)
        elif code in BY_GZ or REJECTED_BY_GZ in message:
            yield Rejection("gz", code, diagnostic.message, diagnostic.span)


def _of_nothing(conversion: SdfConversion) -> Rejection:
    """The rejection of a model without remaining links."""
    message, place = "the robot has no link", conversion.model.root
    for body in conversion.massless[:1]:
        place = body.top.at
        message = (
            f"link '{body.top.name}' has no mass: it is dropped with all links below it, and no "
            "link remains; give it an <inertial>"
        )
    return Rejection("libsdformat", "INE004", message, place.span)


def _of_frames(conversion: SdfConversion) -> Iterator[Rejection]:
    """Frames that are not attached to a link, or have the name of another part."""
    model = conversion.model
    for joint in _merged_joints(conversion):
        child = joint.child_name
        if child in conversion.dropped:
            reason = conversion.dropped[child]
            message = (
                f"'{child}' is merged into a link that is dropped ({reason}), and its frame "
                "has no link; give that link a mass"
            )
            yield Rejection("gz", "INE004", message, joint.at.span)
    for name, joint in _shared_frames(conversion):
        message = (
            f"the frame of the merged '{name}' has the name of another link, joint or frame; "
            "rename one of them"
        )
        is_both = name in model.joints_by_name and name in model.links_by_name
        yield Rejection("gz", "NAM003" if is_both else "", message, joint.at.span)
    taken = _parts(conversion) | _frames(conversion)
    for block in model.gazebo:
        for added in block.children if not block.get("reference") else ():
            name = added.get("name") or ""
            if added.tag not in ("frame", "model"):
                continue
            if name in taken:
                message = f"another part has the name '{name}'; rename one of the two"
                yield Rejection("gz", "", message, added.span)
            taken.add(name)


def shared_frames(conversion: SdfConversion) -> frozenset[str]:
    """Names of merged links and joints that another link, joint or frame of the SDF has."""
    return frozenset(name for name, _ in _shared_frames(conversion))


def _shared_frames(conversion: SdfConversion) -> Iterator[tuple[str, Joint]]:
    """Names that merged links and joints share with another part, with the merged joint."""
    taken = _parts(conversion)
    for joint in _merged_joints(conversion):
        for name in (joint.name, joint.child_name):
            if name in taken:
                yield name, joint
            taken.add(name)


def _parts(conversion: SdfConversion) -> set[str]:
    """Names of the links and joints of the SDF."""
    return {link.name for link in conversion.links} | conversion.joint_names | conversion.added


def _frames(conversion: SdfConversion) -> set[str]:
    """Names of the frames of merged links and joints."""
    merged = _merged_joints(conversion)
    return {name for joint in merged for name in (joint.name, joint.child_name)}


def _merged_joints(conversion: SdfConversion) -> list[Joint]:
    """The merged joints that remain as frames."""
    leaves_frames = conversion.converter.has_frames and conversion.tree.is_sound
    return list(filter(conversion.merges, conversion.model.joints)) if leaves_frames else []


def _of_names(conversion: SdfConversion) -> Iterator[Rejection]:
    """Names that are reserved, or shared by two links or joints after the conversion."""
    model = conversion.model
    places = [
        *((link.name, "link", link.body.top.at) for link in conversion.links),
        *((link.get("name") or "", "link", link) for link in conversion.added_links),
        *((joint.joint.name, "joint", joint.joint.at) for joint in conversion.joints),
        *((joint.get("name") or "", "joint", joint) for joint in conversion.added_joints),
    ]
    places += [("world", "link", joint.at) for joint in model.joints if joint.child_name == "world"]
    taken: dict[str, str] = {}
    for name, kind, at in [*places, (model.name, "robot", model.root)]:
        is_reserved = name == "world" and kind != "robot"
        if is_reserved or (name.startswith("__") and name.endswith("__")):
            message = f"{kind} '{name}': the name is reserved in SDF"
            yield Rejection("gz", "NAM004", message, at.span)
        if name in taken and kind != "robot":
            message = f"{kind} '{name}' has the name of a {taken[name]} after the conversion"
            message += "; rename one of the two"
            yield Rejection("gz", "NAM003" if taken[name] != kind else "", message, at.span)
        elif kind != "robot":
            taken[name] = kind


def _of_joints(conversion: SdfConversion) -> Iterator[Rejection]:
    """SDF joints between missing links, and floating joints, which do not remain as frames."""
    for joint, end, into in conversion.lost_joint_ends():
        if into and conversion.converter.has_frames:
            continue  # the joint is attached to its frame
        defect = f"is merged into '{into}'" if into else "is not in the converted model"
        message = (
            f"<joint> '{joint.get('name')}' in <gazebo>: {end.tag} '{end.text.strip()}' {defect}"
        )
        yield Rejection("gz", "GAZ067" if into else "GAZ001", message, end.span)
    for link in conversion.links:
        joint_above = link.body.joint
        if joint_above is not None and joint_above.kind == "floating":
            message = (
                f"floating joint '{joint_above.name}' is not converted: '{link.name}' has no frame"
            )
            yield Rejection("gz", "JNT022", message, joint_above.at.span)


def _of_inertia(conversion: SdfConversion) -> Iterator[Rejection]:
    """Physically impossible masses and inertias of links with all links merged into them."""
    for part in conversion.model.links:
        if part.mass < 0:
            message = f"link '{part.name}' has a mass of {part.mass:g} kg"
            yield Rejection("gz", "INE001", message, (part.inertial or part).at.span)
    for link in conversion.links:
        low, middle, high = sorted(principal_moments(link.properties.tensor))
        slack = _SLACK * max(abs(low), abs(high))
        if low < -slack or low + middle < high - slack:
            moments = f"{low:.3g}, {middle:.3g} and {high:.3g} kg·m²"
            message = f"link '{link.name}' cannot have principal moments {moments}"
            place = link.body.top.inertial or link.body.top
            yield Rejection("gz", "INE003", message, place.at.span)


def _of_masses(conversion: SdfConversion) -> Iterator[Rejection]:
    """Merged links whose centre of mass is not a number: the SDF parser rejects its pose."""
    for joint in conversion.undefined_centers():
        link, into = joint.child_name, joint.parent_name
        message = (
            f"links '{link}' and '{into}' have a total mass of 0: Gazebo cannot compute a centre "
            "of mass; remove <inertial>, or add a mass"
        )
        place = conversion.model.links_by_name[link].inertial or joint
        yield Rejection("libsdformat", "INE004", message, place.at.span)
