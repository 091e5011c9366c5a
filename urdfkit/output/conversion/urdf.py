"""Conversion to URDF: the robot without xacro, in a directory with all referenced files."""

from __future__ import annotations

import os

from urdfkit.lint.context import Context
from urdfkit.lint.loading import read
from urdfkit.output.bundle import Bundle
from urdfkit.output.bundle.consumers import CONSUMERS
from urdfkit.output.bundle.robot import references
from urdfkit.output.bundle.writing import staged
from urdfkit.output.conversion.losses import LossTable
from urdfkit.output.conversion.options import ConversionOptions
from urdfkit.output.conversion.result import REPORT, Conversion, Proof, proven
from urdfkit.text.document import Element


def write(robot: Context, out: str, _: ConversionOptions, *, force: bool) -> Conversion:
    """Write a robot; the arguments and errors are those of `urdfkit.output.conversion.convert`."""
    bundle = Bundle(robot, CONSUMERS["any"])
    with staged(bundle.files(), out, force=force, mark=REPORT) as directory:
        proof = proven(prove(read(os.path.join(directory, bundle.urdf)), robot), robot)
        entries = tuple(_losses(robot, bundle).entries(robot.document.root, "", {}))
        counts = {
            "link": len(robot.model.links),
            "joint": len(robot.model.joints),
            "file": len(bundle.contents),
        }
        conversion = Conversion("urdf", bundle.urdf, "", counts, entries, proof)
        conversion.write_report(directory)
    return conversion


def prove(written: Context, robot: Context) -> Proof:
    """Compare the written URDF with the robot."""
    names = {id(reference.at) for reference in references(robot.model)}
    ours, theirs = ([*context.document.root.walk()] for context in (robot, written))
    different = abs(len(ours) - len(theirs)) + sum(
        _content(before, names) != _content(after, names, like=before)
        for before, after in zip(ours, theirs, strict=False)
    )
    missing = len(written.files.missing)
    return Proof(
        not different and not missing,
        f"all {len(ours)} elements are unchanged when read again, and all files exist",
        f"the URDF does not agree with the robot: {different} elements differ, "
        f"{missing} files are missing",
        {"elements": len(ours), "different": different, "missing": missing},
    )


def _content(
    element: Element, names: set[int], like: Element | None = None
) -> tuple[str, str, dict[str, str]]:
    """Tag, text and attributes of an element, without file names."""
    attributes = (like or element).attributes
    left = {name for name, at in attributes.items() if id(at) in names}
    values = {name: at.value for name, at in element.attributes.items() if name not in left}
    return element.tag, element.text.strip(), values


def _losses(robot: Context, bundle: Bundle) -> LossTable:
    losses = LossTable()
    by_path = {}
    for element in robot.document.root.walk():
        by_path[element.path] = element
        losses.keep(element, "as written")
        for attribute in element.attributes.values():
            losses.keep(attribute, "as written")
    changes = {entry.path: entry.change for entry in bundle.contents}
    for reference in bundle.renamed:
        name = by_path[reference.element.partition("@")[0]].attributes.get("filename")
        if changes[reference.new]:
            losses.approximate(name, changes[reference.new])
        else:
            losses.keep(name, f"copied as {reference.new}")
    for path, value in bundle.outside:
        losses.approximate(by_path[path], f"'{value}' refers to a file that is not copied")
    return losses
