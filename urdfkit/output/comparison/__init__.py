"""Comparison of two states of a robot by links, joints, meshes and findings."""

from __future__ import annotations

import os
from math import dist

from urdfkit.core import disk
from urdfkit.core.progress import Progress, silent
from urdfkit.core.record import Record
from urdfkit.core.spatial import Vector
from urdfkit.core.temporary import scratch
from urdfkit.lint.context import Context
from urdfkit.lint.options import Options
from urdfkit.output.comparison.differences import KINDS as OF_MODELS
from urdfkit.output.comparison.differences import Difference, RenamedParts, Tolerances, differences
from urdfkit.output.comparison.frames import MovedLink, moved_frames
from urdfkit.output.comparison.renames import renames
from urdfkit.output.comparison.states import RobotState
from urdfkit.output.comparison.surfaces import changed_surfaces
from urdfkit.robot.composite_body import CompositeBody, composite_body
from urdfkit.robot.kinematics import frames
from urdfkit.text.diagnostic import Diagnostic, Severity
from urdfkit.text.source import without_directory

#: Kinds of differences; ``findings`` are new warnings and errors.
KINDS = (*OF_MODELS, "meshes", "findings")


class Comparison(Record):
    """Differences between two states of a robot.

    Attributes:
        before, after: the states, as passed.
        differences: of links and joints, above the tolerances.
        names: renamed links and joints.
        moved: links with another pose when all joints are at zero, the farthest first.
        whole, whole_after: the robot as one body, all joints at zero, in the frame of its root.
        new_findings, fixed_findings: of the check, without those in both states.
        notes: sentences on parts that could not be compared.
        tolerances: the tolerances of the comparison.
        images: URIs of images of both states; empty if not requested.
        directories: workspaces of both states; a page shows paths relative to them.
    """

    before: str
    after: str
    differences: tuple[Difference, ...]
    names: RenamedParts
    moved: tuple[MovedLink, ...]
    whole: CompositeBody
    whole_after: CompositeBody
    new_findings: tuple[Diagnostic, ...]
    fixed_findings: tuple[Diagnostic, ...]
    notes: tuple[str, ...]
    tolerances: Tolerances
    images: tuple[str, ...] = ()
    directories: tuple[str, ...] = ()

    @property
    def centers(self) -> tuple[Vector, Vector] | None:
        """Centres of mass before and after, in m; None if either is undefined or unknown."""
        old, new = self.whole.properties, self.whole_after.properties
        return (old.center, new.center) if old and new and old.mass and new.mass else None

    @property
    def center_moved(self) -> float:
        """Distance in m by which the centre of mass of the robot moved; 0 if unknown."""
        return dist(*self.centers) if self.centers else 0.0

    @property
    def total_differs(self) -> bool:
        """True if the total mass or its centre differ by more than the tolerances."""
        old, new = self.whole.mass, self.whole_after.mass
        allowed = self.tolerances
        by_mass = abs(new - old) > allowed.mass * max(abs(old), abs(new))
        return by_mass or self.center_moved > allowed.position

    @property
    def kinds(self) -> set[str]:
        """The `KINDS` of all differences."""
        kinds = {difference.kind for difference in self.differences}
        if self.moved:
            kinds.add("frames")
        if self.total_differs:
            kinds.add("masses")
        if any(kinds.severity is not Severity.INFO for kinds in self.new_findings):
            kinds.add("findings")
        return kinds


def compare(
    before: str,
    after: str,
    options: Options = Options(),
    *,
    tolerances: Tolerances | None = None,
    has_images: bool = False,
    progress: Progress | None = None,
) -> Comparison:
    """Compare two states of a robot.

    Args:
        before: a URDF or xacro file, or one in git: ``REVISION:PATH``, the path from the current
            directory or from the top of the repository.
        after: the second state, as ``before``.
        options: of the checks of both states; packages of the repository are read at the revision.
        tolerances: by default, those of the class.
        has_images: draw both states, if the required libraries are installed.
        progress: called with the number of finished steps and of all steps.

    Raises:
        UnreadableFile: a file is missing.
        UnreadableRobot: a state cannot be read; with every reason.
        ConfigError: a file has several variants, or lacks this variant.
        UrdfkitError: the revision does not exist, or git is not installed.
    """
    advance = progress or silent
    steps = 4 if has_images else 3
    with scratch() as directory:
        states: list[RobotState] = []
        for word, name in ((before, "before"), (after, "after")):
            advance(len(states), steps)
            where = os.path.join(os.path.realpath(directory), name)
            states.append(RobotState(word, where, options))
        advance(2, steps)
        comparison = _compare(states[0], states[1], tolerances or Tolerances())
        if has_images:
            from urdfkit.output.comparison.images import images

            advance(3, steps)
            rendered = images(states[0].context, states[1].context, comparison)
            comparison = comparison._replace(images=rendered)
        for state in states:
            state.rename_sources()
    return comparison


def _compare(before: RobotState, after: RobotState, allowed: Tolerances) -> Comparison:
    old, new = before.context, after.context
    names = renames(old.model, new.model, allowed)
    found = differences(old.model, new.model, allowed, names)
    changed, notes = changed_surfaces(old, new, allowed, names)
    new_findings, fixed_findings = _findings(before, after, names)
    return Comparison(
        before.word,
        after.word,
        (*found, *changed),
        names,
        moved_frames(old.tree, new.tree, allowed, names),
        composite_body(old.tree, frames(old.tree, {})),
        composite_body(new.tree, frames(new.tree, {})),
        new_findings,
        fixed_findings,
        tuple(notes),
        allowed,
        directories=tuple(dict.fromkeys((*_directories(old), *_directories(new)))),
    )


def _directories(context: Context) -> tuple[str, str]:
    """The workspace of a robot, and the directory of its file."""
    file = disk.real(context.source.path)
    return context.resolver.packages.workspace(file), os.path.dirname(file)


def portable(text: str, comparison: Comparison) -> str:
    """A page without directories of this machine."""
    for directory in comparison.directories:
        text = without_directory(text, directory)
    return without_directory(text, os.path.expanduser("~"), "~/")


def _findings(
    before: RobotState, after: RobotState, names: RenamedParts
) -> tuple[tuple[Diagnostic, ...], tuple[Diagnostic, ...]]:
    """New findings, and fixed findings.

    Findings are matched by rule and elements: numbers, lines and names may have changed.
    """
    old, new = before.report.diagnostics, after.report.diagnostics
    old_keys = {key for finding in old for key in _keys(finding, names)}
    new_keys = {key for finding in new for key in _keys(finding)}
    new_findings = tuple(finding for finding in new if old_keys.isdisjoint(_keys(finding)))
    fixed_findings = tuple(finding for finding in old if new_keys.isdisjoint(_keys(finding, names)))
    return new_findings, fixed_findings


def _keys(finding: Diagnostic, names: RenamedParts | None = None) -> set[tuple[str, str]]:
    elements = {_renamed(call.element, names) for call in finding.calls} - {""}
    if not elements:  # the finding concerns the text, which may be laid out anew
        line = finding.span.source.line(finding.span.line)
        elements = {" ".join(line.split()), finding.message}
    return {(finding.code, element) for element in elements}


def _renamed(element: str, names: RenamedParts | None) -> str:
    """Path of an element in the state after, such as ``link/arm/visual``."""
    tag, _, rest = element.partition("/")
    if names is None or tag not in ("link", "joint"):
        return element
    name, slash, rest = rest.partition("/")
    known = names.links if tag == "link" else names.joints
    return f"{tag}/{known.get(name, name)}{slash}{rest}"
