"""Conversion to USD by the converter of the Newton project, with its warnings at source lines.

https://github.com/newton-physics/urdf-usd-converter, which reads a bundle of the robot.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Mapping
from pathlib import PurePosixPath

import urdf_usd_converter
from pxr import Tf, Usd, UsdUtils

from urdfkit.core import atomic, temporary
from urdfkit.core.record import Record
from urdfkit.core.spatial import from_quaternion, to_rpy
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
from urdfkit.output.conversion.usd_proof import prove
from urdfkit.output.conversion.usd_rotations import write_rotations
from urdfkit.output.conversion.usd_stage import Stage
from urdfkit.robot.origin import reads_quaternions
from urdfkit.robot.values import numbers
from urdfkit.text.diagnostic import Edit
from urdfkit.text.document import Element
from urdfkit.text.editing.apply import apply_edits
from urdfkit.text.editing.edits import remove_attribute, rename_attribute, replace_value
from urdfkit.text.source import Source, shown
from urdfkit.text.xml_reader import read_xml

#: COLLADA is converted, to apply its units and axes as urdfkit does elsewhere.
_CONSUMER = Consumer("usd", "urdf-usd-converter", (BINARY_STL, OBJ), ".obj")
#: Warnings about the converter, not about the robot.
_OF_PROGRAM = re.compile(r"\bdeprecated\b", re.IGNORECASE)
_AT_LINE = re.compile(r"(?:^|: )(?P<tag>[\w.-]+): (?P<text>.*) \(line: (?P<line>\d+)\)$")


class ConverterWarning(Record):
    """A warning of the converter."""

    element: Element  # the element concerned; the root if unknown
    text: str
    is_loss: bool  # True if the element is not converted


def write(robot: Context, out: str, _: ConversionOptions, *, force: bool) -> Conversion:
    """Write a robot; the arguments and errors are those of `urdfkit.output.conversion.convert`."""
    require_meaning(robot)
    bundle = Bundle(robot, _CONSUMER)
    with staged((), out, force=force, mark=REPORT) as directory, temporary.scratch() as scratch:
        atomic.make_directory(directory)
        write_files(bundle.files(), scratch)
        places = _ConvertedElements(robot, bundle, os.path.join(scratch, bundle.urdf))
        warnings = _converted(robot, places, directory)
        file = os.path.join(directory, f"{bundle.name}.usda")
        write_rotations(Stage(Usd.Stage.Open(file), robot), robot)
        stage = Stage(Usd.Stage.Open(file), robot)
        proof = proven(prove(stage, robot), robot)
        losses = LossTable()
        mark_parts(losses, robot, stage)
        prims = {str(prim.GetPath()): body.at for prim, body in stage.shapes}
        for warned in (places.find(text, prims) for text in warnings):
            mark = losses.lose if warned.is_loss else losses.approximate
            mark(warned.element, warned.text)
        entries = tuple(losses.entries(robot.document.root, OTHERWISE, {}))
        conversion = Conversion("usd", f"{bundle.name}.usda", "fixed", stage.counts, entries, proof)
        conversion.write_report(directory)
    return conversion


def _converted(robot: Context, places: _ConvertedElements, directory: str) -> list[str]:
    """Run the converter; returns its warnings.

    Raises:
        UrdfkitError: the converter rejects the robot.
    """
    delegate = UsdUtils.CoalescingDiagnosticDelegate()
    try:
        urdf_usd_converter.Converter(scene=False).convert(places.path, directory)
    except (ValueError, RuntimeError, Tf.ErrorException) as error:
        warned = places.find(str(error), {})
        reason = f"urdf-usd-converter rejects the robot: {warned.text}"
        hint = f"see 'urdfkit check {shown(robot.source.path)}'"
        raise UrdfkitError(f"{warned.element.span}: {reason}; {hint}") from error
    finally:
        diagnostics = delegate.TakeUncoalescedDiagnostics()
    return [
        diagnostic.commentary
        for diagnostic in diagnostics
        if diagnostic.diagnosticCode != Tf.TF_DIAGNOSTIC_STATUS_TYPE
        and not _OF_PROGRAM.search(diagnostic.commentary)
    ]


def _with_rpy(origin: Element) -> Iterator[Edit]:
    """Edits that replace a quaternion of URDF 1.1, which the converter ignores, by angles."""
    written = origin.attributes.get("quat_xyzw") if origin.tag == "origin" else None
    values = numbers(written.value) if written else None
    if written is not None and values and reads_quaternions(origin):
        angles = " ".join(map(repr, to_rpy(from_quaternion(*values))))
        yield from rename_attribute(written, "rpy") or ()
        yield from replace_value(written, angles) or ()


class _ConvertedElements:
    """Finds elements of a robot by their lines, paths and prims in messages of the converter.

    Args:
        robot: the robot.
        bundle: its written bundle.
        path: path of its URDF, named after the bundle, as the output file has the same name.
    """

    def __init__(self, robot: Context, bundle: Bundle, path: str) -> None:
        self.path = path
        self._root = robot.document.root
        with open(path, "rb") as file:
            source = Source(path, file.read())
        document, _ = read_xml(source)
        assert document is not None  # the bundle was written from it
        name = document.root.attributes.get("name")
        if name is None:
            raise UrdfkitError(f"{self._root.span}: <robot> has no name; give it a name")
        edits = [Edit(name.span, bundle.name)]
        for attribute in document.root.attributes.values():
            key = attribute.name
            if key == "xmlns" or (":" in key and not key.startswith("xmlns:")):
                edits += remove_attribute(attribute) or ()  # other readers ignore it
        for element in document.root.walk():
            edits += _with_rpy(element)
        with open(path, "wb") as file:
            file.write(apply_edits(source.data, edits))
        self._by_line: dict[tuple[str, int], Element] = {}
        for ours, theirs in zip(self._root.walk(), document.root.walk(), strict=True):
            self._by_line.setdefault((theirs.tag, theirs.span.line), ours)
        self._files = {renamed.new: renamed.element.partition("@")[0] for renamed in bundle.renamed}
        self._by_path = {element.path: element for element in self._root.walk()}

    def find(self, text: str, prims: Mapping[str, Element]) -> ConverterWarning:
        """The element that a message is about.

        Args:
            prims: visuals and collisions by the paths of their prims.
        """
        text = " ".join(text.split()).replace(os.path.dirname(self.path) + os.sep, "")
        at = _AT_LINE.search(text)
        if at:
            element = self._by_line.get((at["tag"], int(at["line"])), self._root)
            return ConverterWarning(element, at["text"], element is not self._root)
        for new, path in self._files.items():
            if new in text or PurePosixPath(new).name in text:
                element = self._by_path.get(path, self._root)
                return ConverterWarning(element, text, element is not self._root)
        prim = prims.get(text.rpartition(": ")[2])
        return ConverterWarning(self._root if prim is None else prim, text, is_loss=False)
