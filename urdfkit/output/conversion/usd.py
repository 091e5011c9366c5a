"""USD on disk, by the converter of the Newton project, with its warnings at our lines.

https://github.com/newton-physics/urdf-usd-converter, which takes a bundle of the robot.
"""

from __future__ import annotations

import os
import re
from pathlib import PurePosixPath

import urdf_usd_converter
from pxr import Gf, Sdf, Tf, Usd, UsdUtils

from urdfkit.core import atomic, temporary
from urdfkit.core.record import Record
from urdfkit.core.spatial import transposed
from urdfkit.errors import UrdfkitError
from urdfkit.lint.context import Context
from urdfkit.mesh.io.facts import BINARY_STL, OBJ
from urdfkit.output.bundle import Bundle
from urdfkit.output.bundle.consumers import Consumer
from urdfkit.output.bundle.writing import staged, write_files
from urdfkit.output.conversion.losses import LossTable
from urdfkit.output.conversion.options import ConversionOptions
from urdfkit.output.conversion.requirements import require_meaning
from urdfkit.output.conversion.result import REPORT, Conversion, proven
from urdfkit.output.conversion.usd_losses import OTHERWISE, mark_parts
from urdfkit.output.conversion.usd_proof import Stage, prove
from urdfkit.text.diagnostic import Edit
from urdfkit.text.document import Element
from urdfkit.text.editing.apply import apply_edits
from urdfkit.text.editing.edits import remove_attribute
from urdfkit.text.source import Source, shown
from urdfkit.text.xml_reader import read_xml

#: COLLADA is converted: what it says of units and axes is then applied as everywhere here.
_CONSUMER = Consumer("usd", "urdf-usd-converter", (BINARY_STL, OBJ), ".obj")
_ORIENT = "xformOp:orient"
_AT_LINE = re.compile(r"(?:^|: )(?P<tag>[\w.-]+): (?P<text>.*) \(line: (?P<line>\d+)\)$")


class Warned(Record):
    """What the converter says of an element; of the robot where it names none."""

    element: Element
    text: str


def write(robot: Context, out: str, _: ConversionOptions, *, force: bool) -> Conversion:
    """Write a robot; the arguments and errors are those of `urdfkit.output.conversion.convert`."""
    require_meaning(robot)
    bundle = Bundle(robot, _CONSUMER)
    with staged((), out, force=force, mark=REPORT) as directory, temporary.scratch() as scratch:
        atomic.make_directory(directory)
        write_files(bundle.files(), scratch)
        warnings = _converted(robot, bundle, scratch, directory)
        file = os.path.join(directory, f"{bundle.name}.usda")
        _set_rotations(Stage(Usd.Stage.Open(file), robot), robot)
        stage = Stage(Usd.Stage.Open(file), robot)
        proof = proven(prove(stage, robot), robot)
        losses = LossTable()
        mark_parts(losses, robot, stage)
        for one in warnings:
            losses.lose(one.element, one.text)
        entries = tuple(losses.entries(robot.document.root, OTHERWISE, {}))
        found = Conversion("usd", f"{bundle.name}.usda", "fixed", stage.counts, entries, proof)
        found.write_report(directory)
    return found


def _converted(robot: Context, bundle: Bundle, scratch: str, directory: str) -> list[Warned]:
    """Let the converter write USD, and take what it warns of.

    Raises:
        UrdfkitError: it rejects the robot.
    """
    path = os.path.join(scratch, bundle.urdf)
    places = _ConvertedElements(robot, bundle, path)
    delegate = UsdUtils.CoalescingDiagnosticDelegate()
    try:
        urdf_usd_converter.Converter(scene=False).convert(path, directory)
    except (ValueError, RuntimeError, Tf.ErrorException) as error:
        warned = places.find(str(error))
        why = f"urdf-usd-converter rejects the robot: {warned.text}"
        see = f"see 'urdfkit check {shown(robot.source.path)}'"
        raise UrdfkitError(f"{warned.element.span}: {why}; {see}") from error
    finally:
        diagnostics = delegate.TakeUncoalescedDiagnostics()
    return [
        places.find(one.commentary)
        for one in diagnostics
        if one.diagnosticCode != Tf.TF_DIAGNOSTIC_STATUS_TYPE
    ]


def _set_rotations(stage: Stage, robot: Context) -> None:
    """Give the prims of links the rotations of their joints, in double precision.

    The converter computes with the arc cosine of a single precision number, as USD does with what
    it writes: small rotations are up to 5e-4 rad off then.
    """
    changed = set()
    for name, prim in stage.links.items():
        for joint in robot.tree.parents[name]:
            (old,) = prim.GetAttribute(_ORIENT).GetPropertyStack(Usd.TimeCode.Default())
            owner = old.owner
            owner.RemoveProperty(old)
            new = Sdf.AttributeSpec(owner, _ORIENT, Sdf.ValueTypeNames.Quatd)
            turned = Gf.Matrix3d(*(one for row in transposed(joint.origin.rotation) for one in row))
            new.default = Gf.Matrix4d(turned, Gf.Vec3d()).ExtractRotationQuat()
            changed.add(owner.layer)
    for layer in changed:
        layer.Save()


class _ConvertedElements:
    """The elements of a robot, by what the converter calls them.

    Args:
        robot: as it was read.
        bundle: of it, written.
        path: of its URDF, which is given the name of the bundle: it becomes that of a file.
    """

    def __init__(self, robot: Context, bundle: Bundle, path: str) -> None:
        self._root = robot.document.root
        with open(path, "rb") as file:
            source = Source(path, file.read())
        document, _ = read_xml(source)
        assert document is not None  # it was written from one
        name = document.root.attributes.get("name")
        if name is None:
            raise UrdfkitError(f"{self._root.span}: <robot> has no name; give it one")
        edits = [Edit(name.span, bundle.name)]
        for one in document.root.attributes.values():
            if one.name == "xmlns" or (":" in one.name and not one.name.startswith("xmlns:")):
                edits += remove_attribute(one) or ()  # which other readers ignore
        with open(path, "wb") as file:
            file.write(apply_edits(source.data, edits))
        self._by_line: dict[tuple[str, int], Element] = {}
        for ours, theirs in zip(self._root.walk(), document.root.walk(), strict=True):
            self._by_line.setdefault((theirs.tag, theirs.span.line), ours)
        self._files = {one.new: one.element.partition("@")[0] for one in bundle.renamed}
        self._by_path = {element.path: element for element in self._root.walk()}

    def find(self, text: str) -> Warned:
        """The element that a message is about."""
        text = " ".join(text.split())
        at = _AT_LINE.search(text)
        if at:
            found = self._by_line.get((at["tag"], int(at["line"])), self._root)
            return Warned(found, at["text"])
        for new, path in self._files.items():
            if new in text or PurePosixPath(new).name in text:
                return Warned(self._by_path.get(path, self._root), text)
        return Warned(self._root, text)
