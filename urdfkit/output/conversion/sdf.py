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
from urdfkit.output.bundle import Bundle
from urdfkit.output.bundle.consumers import CONSUMERS, Consumer
from urdfkit.output.bundle.meshes import BundledFile
from urdfkit.output.bundle.robot import mesh_references
from urdfkit.output.bundle.writing import staged, write_files
from urdfkit.output.conversion.losses import LossTable
from urdfkit.output.conversion.options import ConversionOptions
from urdfkit.output.conversion.result import REPORT, Conversion, proven
from urdfkit.output.conversion.sdf_extensions import set_value
from urdfkit.output.conversion.sdf_losses import OTHERWISE, REASONS, record_losses
from urdfkit.output.conversion.sdf_model import VERSION, SdfModel
from urdfkit.output.conversion.sdf_proof import prove
from urdfkit.output.conversion.sdf_reader import Sdf
from urdfkit.output.conversion.sdf_refusal import require
from urdfkit.ros.gazebo.conversion import NEW, SdfConversion
from urdfkit.text.source import Source

_CONSUMER = Consumer("sdf", "Gazebo", CONSUMERS["ros"].reads, ".dae")
#: Names that Gazebo looks for in the directory of a model.
MODEL, CONFIG = "model.sdf", "model.config"


def write(robot: Context, out: str, _: ConversionOptions, *, force: bool) -> Conversion:
    """Write a robot; the arguments and errors are those of `urdfkit.output.conversion.convert`."""
    if not robot.tree.is_sound:
        raise UrdfkitError(robot.tree.unsound)
    conversion = SdfConversion(robot.tree, NEW)
    require(robot, conversion)
    bundle = Bundle(robot, _CONSUMER)
    with staged((), out, force=force, mark=REPORT) as directory:
        atomic.make_directory(directory)
        # SDF does not support the textures of a URDF.
        meshes = (file for file in bundle.files() if file.path.startswith("meshes/"))
        write_files(meshes, directory)
        references = mesh_references(robot.model)
        names = {id(one): new.new for one, new in zip(references, bundle.renamed, strict=False)}
        model = SdfModel(conversion, names)
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
    set_value(config, "description", f"made of {os.path.basename(robot.source.path)}")
    yield BundledFile(CONFIG, _text(config), "")


def _text(tag: Tag) -> bytes:
    indent(tag)
    text: bytes = tostring(tag, encoding="utf-8", xml_declaration=True)
    return text + b"\n"
