"""Conversion to SDF: the model that Gazebo makes of a robot, in a directory that Gazebo loads.

The SDF equals the output of sdformat 14 to 16, except for names of mesh files. A part that Gazebo
rejects, or that sdformat or urdfdom misread, is an error at its line.
"""

import os
from collections.abc import Iterator
from xml.etree.ElementTree import Element as Tag
from xml.etree.ElementTree import indent, tostring

from urdfkit.core import atomic
from urdfkit.errors import UrdfkitError
from urdfkit.lint.context import Context
from urdfkit.lint.runner import run_rules
from urdfkit.output.bundle import Bundle
from urdfkit.output.bundle.consumers import CONSUMERS, Consumer
from urdfkit.output.bundle.meshes import BundledFile
from urdfkit.output.bundle.writing import staged, write_files
from urdfkit.output.conversion.losses import LossTable
from urdfkit.output.conversion.options import ConversionOptions
from urdfkit.output.conversion.result import REPORT, Conversion, proven
from urdfkit.output.conversion.sdf_extensions import set_value
from urdfkit.output.conversion.sdf_losses import OTHERWISE, REASONS, record_losses
from urdfkit.output.conversion.sdf_model import VERSION, SdfModel
from urdfkit.output.conversion.sdf_proof import prove
from urdfkit.output.conversion.sdf_reader import Sdf
from urdfkit.robot.link import Link
from urdfkit.ros.gazebo.conversion import JOINT_TYPES, NEW, SdfConversion
from urdfkit.ros.gazebo.rejection import CODES, IN_JOINTS, rejections
from urdfkit.text.diagnostic import Severity
from urdfkit.text.document import Element
from urdfkit.text.source import Source, Span

_CONSUMER = Consumer("sdf", "Gazebo", CONSUMERS["ros"].reads, ".dae")
#: Names that Gazebo looks for in the directory of a model.
MODEL, CONFIG = "model.sdf", "model.config"
#: Shapes that urdfdom reads, and the attribute that each shape requires.
_SHAPES = {"box": "size", "cylinder": "radius", "sphere": "radius", "mesh": "filename"}
#: Greatest depth of nested elements in tinyxml2, which sdformat uses.
_MAX_DEPTH = 500


def write(robot: Context, out: str, _: ConversionOptions, *, force: bool) -> Conversion:
    """Write a robot; the arguments and errors are those of `urdfkit.output.conversion.convert`."""
    if not robot.tree.is_sound:
        raise UrdfkitError(robot.tree.unsound)
    conversion = SdfConversion(robot.tree, NEW)
    _require_convertible(robot, conversion)
    bundle = Bundle(robot, _CONSUMER)
    with staged((), out, force=force, mark=REPORT) as directory:
        atomic.make_directory(directory)
        # SDF does not support the textures of a URDF.
        meshes = (file for file in bundle.files() if file.path.startswith("meshes/"))
        write_files(meshes, directory)
        model = SdfModel(conversion, bundle.new_references)
        write_files(_files(robot, model), directory)
        sdf = Sdf(Source.read(os.path.join(directory, MODEL)))
        proof = proven(prove(sdf, robot, conversion), robot)
        losses = LossTable()
        record_losses(losses, conversion, model, bundle)
        entries = tuple(losses.entries(robot.document.root, OTHERWISE, REASONS))
        result = Conversion("sdf", MODEL, "", sdf.counts, entries, proof)
        result.write_report(directory)
    return result


def _files(robot: Context, model: SdfModel) -> Iterator[BundledFile]:
    """The model file, and the configuration file for Gazebo's list of models."""
    sdf = Tag("sdf", {"version": VERSION})
    sdf.append(model.tag)
    yield BundledFile(MODEL, _text(sdf), robot.source.path)
    config = Tag("model")
    set_value(config, "name", robot.model.name)
    set_value(config, "version", "1.0")
    set_value(config, "sdf", MODEL).set("version", VERSION)
    set_value(config, "description", f"converted from {os.path.basename(robot.source.path)}")
    yield BundledFile(CONFIG, _text(config), "")


def _text(tag: Tag) -> bytes:
    indent(tag)
    text: bytes = tostring(tag, encoding="utf-8", xml_declaration=True)
    return text + b"\n"


def _require_convertible(robot: Context, conversion: SdfConversion) -> None:
    """Raise an error at the first part that cannot be converted to SDF.

    Raises:
        UrdfkitError: Gazebo rejects the robot, or loses a part of it.
    """
    diagnostics = run_rules(robot, sorted(CODES)).diagnostics
    for rejection in rejections(diagnostics, conversion):
        hint = f"; see 'urdfkit explain {rejection.code}'" if rejection.code else ""
        raise UrdfkitError(
            f"{rejection.span}: {rejection.reader} rejects the robot: {rejection.message}{hint}"
        )
    for diagnostic in diagnostics:
        if diagnostic.code in IN_JOINTS and diagnostic.severity is Severity.ERROR:
            raise UrdfkitError(
                f"{diagnostic.span}: {diagnostic.message}: Gazebo drops this part of the robot; "
                f"see 'urdfkit explain {diagnostic.code}'"
            )
    for span, message in _defects(conversion):
        raise UrdfkitError(f"{span}: {message}")


def _defects(conversion: SdfConversion) -> Iterator[tuple[Span, str]]:
    model = conversion.model
    if not model.name:
        yield model.root.span, "gz rejects the robot: it has no name; give <robot> a name"
    nested = _too_deep(model.root)
    if nested is not None:
        message = f"Gazebo reads at most {_MAX_DEPTH} nested elements; remove some levels"
        yield nested.span, message
    for link in model.links:
        yield from _of_link(link)
    for simulated in conversion.links:
        joint = simulated.body.joint
        if joint is not None and joint.kind not in JOINT_TYPES:
            message = f"gz rejects the robot: Gazebo does not convert {joint.kind} joints"
            yield joint.at.span, f"{message}; use another type"
        leader = joint.mimic.joint if joint and joint.mimic else None
        if leader is not None and joint is not None and leader.value == joint.name:
            yield leader.span, "gz rejects the robot: the joint mimics itself; name another joint"


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
        subject = f"<{body.at.tag}> of link '{link.name}'"
        if shape is None:
            yield body.at.span, f"{subject} has no shape; add one, or remove it"
        elif shape.kind not in _SHAPES:
            yield (
                shape.at.span,
                f"{subject}: Gazebo does not read <{shape.kind}> in a URDF; use a mesh",
            )
        elif getattr(shape, _SHAPES[shape.kind]) is None:
            yield shape.at.span, f"{subject}: <{shape.kind}> needs {_SHAPES[shape.kind]}; add it"
