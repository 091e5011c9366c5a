"""Assertions about robots, for tests of projects with robot models.

Failed assertions report the measured and the expected value; pytest shows the line of the test.
``urdfkit.pytest_plugin`` provides matching fixtures; with another test runner, create a
`Description`.
"""

from __future__ import annotations

import os
import tempfile
import warnings
from collections.abc import Iterable, Mapping
from fnmatch import fnmatchcase
from functools import cached_property
from typing import TYPE_CHECKING

from urdfkit.core.suggest import hint_for
from urdfkit.errors import UrdfkitError
from urdfkit.lint.config import Config
from urdfkit.lint.config_reader import load
from urdfkit.lint.context import Context
from urdfkit.lint.engine import check
from urdfkit.lint.loading import context_of
from urdfkit.lint.report import Report
from urdfkit.lint.rule_index import matching
from urdfkit.lint.unknown_arguments import unknown_arguments
from urdfkit.output.comparison.differences import Tolerances, differences
from urdfkit.output.comparison.renames import renames
from urdfkit.robot.joint import Joint
from urdfkit.robot.model import RobotModel
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
    """A model with its arguments and its configuration; it is read once.

    An argument that it does not declare makes a warning: xacro ignores it, and a test with a typo
    would pass with another robot.

    Args:
        path: of the file.
        arguments: for xacro; they override those of the configuration.
        config: the configuration; that of the nearest configuration file if None.
        variant: name of a variant in the configuration.

    Raises:
        ConfigError: the configuration has several variants of the file, or not the given one.
    """

    def __init__(
        self,
        path: str,
        arguments: Mapping[str, str] | None = None,
        config: Config | None = None,
        variant: str = "",
    ) -> None:
        self.path = path  # of the file
        self.config = _config(path) if config is None else config  # its configuration
        #: For xacro, including those of the configuration.
        self.arguments = self.config.entry(path, arguments, variant).arguments
        self._passed = tuple(arguments or ())

    @cached_property
    def report(self) -> Report:
        """The report of ``urdfkit check``."""
        config = self.config._replace(robots=())
        report = check(self.path, arguments=self.arguments, config=config)
        self._warn_of_unknown(report.unknown_arguments)
        return report

    @property
    def model(self) -> RobotModel:
        """The robot.

        Raises:
            AssertionError: the file is unreadable; with the findings.
        """
        return self.context.model

    @cached_property
    def context(self) -> Context:
        """The robot with all derived data.

        Raises:
            AssertionError: the file is unreadable; with the findings.
        """
        resolver = Resolver(dict(self.config.packages))
        source, trust = Source.read(self.path), self.config.trust
        context = context_of(source, resolver, self.arguments, trust=trust, cache=True)
        if context.reading.document is None:
            raise AssertionError(_text(self._why_unreadable()))
        self._warn_of_unknown(unknown_arguments(context, self._passed).items())
        return context

    def _warn_of_unknown(self, unknown: Iterable[tuple[str, str]]) -> None:
        """Warn of passed arguments; those of the configuration may be for other robots."""
        for name, suggested in unknown:
            if name in self._passed:
                message = f"{self.path} has no argument '{name}'{hint_for(suggested)}"
                warnings.warn(message, stacklevel=3)

    @cached_property
    def dynamics(self) -> Dynamics:
        """The robot in Pinocchio.

        Raises:
            AssertionError: the file is unreadable; with the findings.
            UrdfkitError: its links and joints do not form a tree, or exceed limits of Pinocchio.
        """
        from urdfkit.physics.dynamics.robot import Dynamics

        return Dynamics(KinematicTree(self.model))

    @property
    def meshes(self) -> tuple[MeshUse, ...]:
        """The measured meshes of its visuals and collisions, without broken files.

        Raises:
            AssertionError: the file is unreadable; with the findings.
            Unavailable: a library that measures meshes is not installed.
        """
        return tuple(self.context.measured.uses)

    def _why_unreadable(self) -> Report:
        """The findings of the reading, regardless of the selected rules."""
        config = self.config._replace(robots=(), select=frozenset(), ignore=frozenset())
        return check(self.path, arguments=self.arguments, config=config, select=("XML", "XAC"))


def _config(path: str) -> Config:
    config_path = nearest(os.path.dirname(os.path.abspath(path)))
    return Config() if config_path is None else load(config_path)


def variants(path: str) -> list[str]:
    """Names of the variants of a model in the configuration; one empty name without variants."""
    return [robot.name for robot in _config(path).entries(path)]


def assert_no_findings(
    report: Report, *, fail_on: Severity = Severity.WARNING, ignore: Iterable[str] = ()
) -> None:
    """Fail with the report if it has findings.

    Args:
        report: of ``urdfkit.check`` or a fixture.
        fail_on: the lowest severity that fails.
        ignore: codes, prefixes of codes or names of rules to ignore.

    Raises:
        UnknownRule: an entry of ``ignore`` matches no rule.
    """
    __tracebackhide__ = True
    ignored = {code for entry in ignore for code in matching(entry)}
    counted = report._replace(
        diagnostics=tuple(d for d in report.diagnostics if d.code not in ignored)
    )
    if counted.exit_code(fail_on):
        raise AssertionError(_text(counted))


def _text(report: Report) -> str:
    from urdfkit.output import formats

    return "\n" + formats.get("full")(report)


def assert_dof(model: RobotModel, expected: int) -> None:
    """Fail unless the robot has this number of degrees of freedom; mimic joints have none."""
    __tracebackhide__ = True
    if model.degrees_of_freedom != expected:
        moving = ", ".join(joint.name for joint in model.joints if joint.degrees_of_freedom)
        raise AssertionError(
            f"{model.degrees_of_freedom} degrees of freedom, not {expected}: {moving}"
        )


def assert_mass(model: RobotModel, expected: float, *, tolerance: float = 1e-3) -> None:
    """Fail unless the total mass of the links is as expected.

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
    """Fail unless the limits of joints are within bounds.

    Args:
        model: the robot.
        bounds: minimum and maximum by joint name or pattern, in rad or m (and rad/s, N·m).
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
    """Fail if links collide in the initial pose or in random configurations within the limits.

    Adjacent links, links of one rigid body, and pairs that the SRDF of the robot's package
    disables are ignored. See ``urdfkit.collisions`` for the method.

    Args:
        description: the model, as the fixture ``urdf`` makes it.
        samples: number of configurations; with 0, only the initial pose is checked.
        seed: of the random configurations.
        begin: initial positions of joints, in rad or m; the others are at 0, or in the middle of
            limits that exclude 0.
        allowed: pairs of links that may collide.

    Raises:
        AssertionError: links collide; with depth and pose.
        UrdfkitError: coal is not installed.
    """
    __tracebackhide__ = True
    matrix = description.context.collisions.matrix(samples=samples, seed=seed, begin=begin)
    srdf = description.context.srdf
    passed = {frozenset(pair) for pair in allowed}
    lines = []
    for pair in matrix.colliding:
        links = frozenset((pair.first, pair.second))
        if links not in passed and not (srdf and srdf.disables(links)) and pair.nearest:
            pose = ", ".join(f"{name} {value:.3g}" for name, value in pair.nearest.pose.items())
            depth = -1000 * pair.nearest.distance
            lines.append(f"'{pair.first}' and '{pair.second}': {depth:.1f} mm deep at {pose}")
    if lines:
        raise AssertionError("links collide:\n" + "\n".join(lines))


def assert_unchanged_since(
    description: Description, revision: str, tolerances: Tolerances | None = None
) -> None:
    """Fail if a model differs from its git revision by more than the tolerances.

    The files of the revision are read from git into a temporary directory; the working tree is not
    touched. Arguments and configuration are the present ones. See
    ``urdfkit.output.comparison.differences`` for the compared values.

    Args:
        description: the model, as the fixture ``urdf`` makes it.
        revision: a tag, branch or commit.
        tolerances: the defaults of the class if None.

    Raises:
        AssertionError: the model differs; with all differences.
        UrdfkitError: the revision does not exist, the file is not in it or was unreadable, or git
            is not installed.
    """
    __tracebackhide__ = True
    with tempfile.TemporaryDirectory() as directory:
        before = _at_revision(description, revision, directory)
        after, allowed = description.model, tolerances or Tolerances()
        changes = differences(before, after, allowed, renames(before, after, allowed))
    if changes:
        raise AssertionError(f"since {revision}:\n" + "\n".join(map(str, changes)))


def _at_revision(description: Description, revision: str, directory: str) -> RobotModel:
    """The model in a revision; its files are written to a directory."""
    config = description.config
    old = check_out_snapshot(description.path, revision, directory, config.packages)
    config = config._replace(packages=old.packages, robots=())
    then = Description(old.path, description.arguments, config)
    try:
        return then.model
    except AssertionError as error:
        raise UrdfkitError(f"{description.path} at {revision} cannot be read:{error}") from error
