"""Assertions about robots, for the tests of projects that hold models.

Every failed assertion says what was measured and what was expected; pytest shows the line of the
test that made it. ``urdfkit.pytest_plugin`` has fixtures that go with them; with another
test runner, start from a Description.
"""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterable, Mapping
from fnmatch import fnmatchcase
from functools import cached_property
from typing import TYPE_CHECKING

from urdfkit.errors import UrdfkitError
from urdfkit.lint.config import Config
from urdfkit.lint.config_reader import load
from urdfkit.lint.context import Context
from urdfkit.lint.engine import check
from urdfkit.lint.loading import context_of
from urdfkit.lint.report import Report
from urdfkit.lint.rule_index import matching
from urdfkit.output.comparison.differences import Tolerances, differences
from urdfkit.output.comparison.renames import renames
from urdfkit.robot.model import Joint, RobotModel
from urdfkit.robot.tree import KinematicTree
from urdfkit.text.diagnostic import Severity
from urdfkit.text.source import Source
from urdfkit.workspace.config_file import nearest
from urdfkit.workspace.resolve import Resolver
from urdfkit.workspace.snapshots import check_out_snapshot

if TYPE_CHECKING:
    from urdfkit.physics.dynamics.robot import Dynamics
    from urdfkit.robot.assets.mesh_uses import MeshUse

__all__ = [
    "Description",
    "Tolerances",
    "assert_dof",
    "assert_limits_within",
    "assert_mass",
    "assert_no_findings",
    "assert_no_self_collision",
    "assert_unchanged_since",
]


class Description:
    """One model with its arguments, read once, under the nearest configuration.

    Args:
        path: of the file.
        arguments: for xacro; they win over those of the configuration.
        config: the settings that hold for it; those of the nearest file unless given.
        variant: which of those that the configuration has of the file.

    Raises:
        ConfigError: the configuration has several variants of the file, or none of this name.
    """

    def __init__(
        self,
        path: str,
        arguments: Mapping[str, str] | None = None,
        config: Config | None = None,
        variant: str = "",
    ) -> None:
        self.path = path  # of the file
        self.config = _config(path) if config is None else config  # the settings that hold for it
        #: For xacro, with those of the configuration.
        self.arguments = self.config.entry(path, arguments, variant).arguments

    @cached_property
    def report(self) -> Report:
        """What ``urdfkit check`` says."""
        config = self.config._replace(robots=())
        return check(self.path, arguments=self.arguments, config=config)

    @property
    def model(self) -> RobotModel:
        """The robot.

        Raises:
            AssertionError: it cannot be read; with what is wrong with it.
        """
        return self.context.model

    @cached_property
    def context(self) -> Context:
        """The robot, with all that can be computed of it.

        Raises:
            AssertionError: it cannot be read; with what is wrong with it.
        """
        resolver = Resolver(dict(self.config.packages))
        source, trust = Source.read(self.path), self.config.trust
        context = context_of(source, resolver, self.arguments, trust=trust, cache=True)
        if context.reading.document is None:
            raise AssertionError(_text(self._why_unreadable()))
        return context

    @cached_property
    def dynamics(self) -> Dynamics:
        """The robot in Pinocchio.

        Raises:
            AssertionError: it cannot be read; with what is wrong with it.
            UrdfkitError: its links and joints form no tree, or are beyond what Pinocchio holds.
        """
        from urdfkit.physics.dynamics.robot import Dynamics

        return Dynamics(KinematicTree(self.model))

    @property
    def meshes(self) -> tuple[MeshUse, ...]:
        """The meshes in its visuals and collisions, measured; those that are broken are left out.

        Raises:
            AssertionError: it cannot be read; with what is wrong with it.
            Unavailable: a library that measures meshes is not installed.
        """
        return tuple(self.context.measured.uses)

    def _why_unreadable(self) -> Report:
        """Whatever rules the project selects."""
        config = self.config._replace(robots=(), select=frozenset(), ignore=frozenset())
        return check(self.path, arguments=self.arguments, config=config, select=("XML", "XAC"))


def _config(path: str) -> Config:
    found = nearest(os.path.dirname(os.path.abspath(path)))
    return Config() if found is None else load(found)


def variants(path: str) -> list[str]:
    """The names of a model's variants in its project's configuration; an empty one without any."""
    return [robot.name for robot in _config(path).entries(path)]


def assert_no_findings(
    report: Report, *, fail_on: Severity = Severity.WARNING, ignore: Iterable[str] = ()
) -> None:
    """Fail with the report if it has findings.

    Args:
        report: of ``urdfkit.check`` or a fixture.
        fail_on: the mildest severity that counts.
        ignore: codes, beginnings of codes or names of rules that do not count.

    Raises:
        UnknownRule: a word of ``ignore`` means no rule.
    """
    __tracebackhide__ = True
    ignored = {code for word in ignore for code in matching(word)}
    kept = report._replace(
        diagnostics=tuple(d for d in report.diagnostics if d.code not in ignored)
    )
    if kept.exit_code(fail_on):
        raise AssertionError(_text(kept))


def _text(report: Report) -> str:
    from urdfkit.output.formats.full import render

    return "\n" + render(report)


def assert_dof(model: RobotModel, expected: int) -> None:
    """Fail unless the robot has so many degrees of freedom; followers of mimic have none."""
    __tracebackhide__ = True
    if model.degrees_of_freedom != expected:
        moving = ", ".join(joint.name for joint in model.joints if joint.degrees_of_freedom)
        raise AssertionError(
            f"{model.degrees_of_freedom} degrees of freedom, not {expected}: {moving}"
        )


def assert_mass(model: RobotModel, expected: float, *, tolerance: float = 1e-3) -> None:
    """Fail unless the total mass of the links is this.

    Args:
        model: the robot.
        expected: in kg.
        tolerance: in kg.
    """
    __tracebackhide__ = True
    if abs(model.mass - expected) > tolerance:
        raise AssertionError(f"total mass {model.mass:g} kg, not {expected:g} +- {tolerance:g} kg")


def assert_limits_within(
    model: RobotModel, bounds: Mapping[str, tuple[float, float]], *, of: str = "position"
) -> None:
    """Fail unless the limits of some joints are within bounds.

    Args:
        model: the robot.
        bounds: least and greatest value by joint name or pattern, in rad or m (and rad/s, N·m).
        of: ``position``, ``velocity`` or ``effort``.
    """
    __tracebackhide__ = True
    wrong: list[str] = []
    for pattern, (least, greatest) in bounds.items():
        joints = [joint for joint in model.joints if fnmatchcase(joint.name, pattern)]
        if not joints:
            wrong.append(f"no joint '{pattern}'")
        for joint in joints:
            for name, value in _limits(joint, of).items():
                if value is None:
                    wrong.append(f"joint '{joint.name}' has no {name}")
                elif not least <= value <= greatest:
                    bound = f"{least:g} to {greatest:g}"
                    wrong.append(f"joint '{joint.name}': {name} {value:g} is outside {bound}")
    if wrong:
        raise AssertionError("\n".join(wrong))


def _limits(joint: Joint, of: str) -> dict[str, float | None]:
    names = ("lower", "upper") if of == "position" else (of,)
    limits = {name: getattr(joint.limit, name) if joint.limit else None for name in names}
    return {name: placed.value if placed else None for name, placed in limits.items()}


def assert_no_self_collision(
    description: Description,
    *,
    samples: int = 1000,
    seed: int = 0,
    begin: Mapping[str, float] | None = None,
    allowed: Iterable[tuple[str, str]] = (),
) -> None:
    """Fail if two links collide in the initial pose, or in samples within its limits.

    Adjacent links and links of one rigid body do not count, nor do pairs that the SRDF of the
    robot's package disables. ``urdfkit.collisions`` says what is measured.

    Args:
        description: the model, as the fixture ``urdf`` makes it.
        samples: configurations; 0 for none but the one where the robot begins.
        seed: of these.
        begin: positions of joints, in rad or m; the others begin at 0, or in the middle if 0 is
            beyond their limits.
        allowed: pairs of links that may collide.

    Raises:
        AssertionError: some do; with depth and pose.
        UrdfkitError: coal is not installed.
    """
    __tracebackhide__ = True
    matrix = description.context.collisions.matrix(samples=samples, seed=seed, begin=begin)
    srdf = description.context.srdf
    passed = {frozenset(pair) for pair in allowed}
    found = []
    for pair in matrix.colliding:
        links = frozenset((pair.first, pair.second))
        if links not in passed and not (srdf and srdf.disables(links)) and pair.nearest:
            pose = ", ".join(f"{name} {at:.3g}" for name, at in pair.nearest.pose.items())
            depth = -1000 * pair.nearest.distance
            found.append(f"'{pair.first}' and '{pair.second}': {depth:.1f} mm deep at {pose}")
    if found:
        raise AssertionError("links collide:\n" + "\n".join(found))


def assert_unchanged_since(
    description: Description, revision: str, tolerances: Tolerances | None = None
) -> None:
    """Fail if a model differs from a git revision of it by more than the tolerances.

    The files of that revision are read from git into a temporary directory; the working tree is
    not touched. Arguments and settings are the present ones.
    ``urdfkit.output.comparison.differences`` says what is compared.

    Args:
        description: the model, as the fixture ``urdf`` makes it.
        revision: a tag, branch or commit.
        tolerances: those of the class unless given.

    Raises:
        AssertionError: it differs; with every difference.
        UrdfkitError: there is no such revision, the file is not in it or cannot be read as it
            was, or git is not there.
    """
    __tracebackhide__ = True
    with tempfile.TemporaryDirectory() as directory:
        before = _as_it_was(description, revision, directory)
        after, allowed = description.model, tolerances or Tolerances()
        found = differences(before, after, allowed, renames(before, after, allowed))
    if found:
        raise AssertionError(f"since {revision}:\n" + "\n".join(map(str, found)))


def _as_it_was(description: Description, revision: str, directory: str) -> RobotModel:
    """The model in a revision, whose files are put into a directory."""
    config = description.config
    old = check_out_snapshot(description.path, revision, directory, config.packages)
    config = config._replace(packages=old.packages, robots=())
    then = Description(old.path, description.arguments, config)
    try:
        return then.model
    except AssertionError as error:
        raise UrdfkitError(f"{description.path} at {revision} cannot be read:{error}") from error
