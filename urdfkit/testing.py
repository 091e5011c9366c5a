"""Assertions about robots, for the tests of projects that hold models.

Every failed assertion says what was measured and what was expected. ``urdfkit.pytest_plugin`` has
fixtures that go with them; with another test runner, start from a Description.
"""

from __future__ import annotations

import os
import subprocess
import tempfile
from collections.abc import Iterable, Mapping
from fnmatch import fnmatchcase
from functools import cached_property
from math import sqrt
from typing import NamedTuple

from urdfkit.config import Config, load, nearest
from urdfkit.diagnostic import Report, Severity
from urdfkit.engine import check
from urdfkit.errors import UrdfkitError
from urdfkit.model import Joint, Link, RobotModel
from urdfkit.resolve import Resolver
from urdfkit.source import Source
from urdfkit.subject import Subject


class Description:
    """One model with its arguments, read once, under the nearest configuration.

    Attributes:
        path: of the file.
        arguments: for xacro.
    """

    def __init__(self, path: str, arguments: Mapping[str, str] | None = None) -> None:
        self.path = path
        self.config = _config(path)
        self.arguments = {**self.config.arguments, **(arguments or {})}

    @cached_property
    def report(self) -> Report:
        """What ``urdfkit check`` says."""
        config = self.config._replace(robots=())
        return check(self.path, arguments=self.arguments, config=config)

    @cached_property
    def model(self) -> RobotModel:
        """The robot.

        Raises:
            AssertionError: it cannot be read; with what is wrong with it.
        """
        resolver = Resolver(dict(self.config.packages))
        subject = Subject(Source.read(self.path), resolver, self.arguments, trust=self.config.trust)
        if subject.reading.document is None:
            raise AssertionError(_text(self.report))
        return subject.model


def _config(path: str) -> Config:
    found = nearest(os.path.dirname(os.path.abspath(path)))
    return Config() if found is None else load(found)


def variants(path: str) -> list[tuple[str, dict[str, str]]]:
    """The variants of a model in its project's configuration, else one without a name."""
    real = os.path.abspath(path)
    found = [(r.name, dict(r.arguments)) for r in _config(path).robots if r.file == real]
    return found or [("", {})]


def assert_no_findings(
    report: Report, *, fail_on: Severity = Severity.WARNING, ignore: Iterable[str] = ()
) -> None:
    """Fail with the report if it has findings.

    Args:
        report: of ``urdfkit.check`` or a fixture.
        fail_on: the mildest severity that counts.
        ignore: codes, or beginnings of codes, that do not count.
    """
    kept = tuple(d for d in report.diagnostics if not d.code.startswith(tuple(ignore) or "-"))
    if report._replace(diagnostics=kept).exit_code(fail_on):
        raise AssertionError(_text(report._replace(diagnostics=kept)))


def _text(report: Report) -> str:
    from urdfkit.formats.text import render

    return "\n" + render(report)


def assert_dof(model: RobotModel, expected: int) -> None:
    """Fail unless the robot has so many degrees of freedom; followers of mimic have none."""
    if model.degrees_of_freedom != expected:
        moving = ", ".join(joint.name for joint in model.joints if joint.degrees_of_freedom)
        raise AssertionError(
            f"{model.degrees_of_freedom} degrees of freedom, not {expected}: {moving}"
        )


def assert_mass(model: RobotModel, expected: float, *, tolerance: float = 1e-3) -> None:
    """Fail unless all links together weigh so much.

    Args:
        model: the robot.
        expected: in kg.
        tolerance: in kg.
    """
    if abs(model.mass - expected) > tolerance:
        raise AssertionError(f"total mass {model.mass:g} kg, not {expected:g} +- {tolerance:g} kg")


def assert_limits_within(
    model: RobotModel, bounds: Mapping[str, tuple[float, float]], *, of: str = "position"
) -> None:
    """Fail unless the limits of some joints are within bounds.

    Args:
        model: the robot.
        bounds: least and greatest value by joint name or pattern, in rad or m (and rad/s, N m).
        of: ``position``, ``velocity`` or ``effort``.
    """
    wrong: list[str] = []
    for pattern, (least, greatest) in bounds.items():
        joints = [joint for joint in model.joints if fnmatchcase(joint.name, pattern)]
        if not joints:
            wrong.append(f"there is no joint '{pattern}'")
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


class Tolerances(NamedTuple):
    """How much a model may differ from another revision of it.

    Attributes:
        mass: relative, per link.
        position: of joint origins, in m.
        rotation: of joint origins, in rad.
        inertia: of the tensor, relative to its greatest entry.
        limit: of joint limits, relative.
        links, joints: True if some may come or go.
    """

    mass: float = 1e-3
    position: float = 1e-4
    rotation: float = 1e-4
    inertia: float = 1e-3
    limit: float = 1e-6
    links: bool = False
    joints: bool = False


def assert_unchanged_since(
    description: Description, revision: str, tolerances: Tolerances | None = None
) -> None:
    """Fail if a model differs from a git revision of it by more than the tolerances.

    The files of that revision are read from git into a temporary folder; the working tree is
    not touched.

    Raises:
        UrdfkitError: there is no such revision, or git is not there.
    """
    with tempfile.TemporaryDirectory() as folder:
        path = _check_out(description.path, revision, folder)
        before = Description(path, description.arguments).model
        found = differences(before, description.model, tolerances or Tolerances())
    if found:
        raise AssertionError(f"since {revision}:\n" + "\n".join(found))


def _check_out(path: str, revision: str, folder: str) -> str:
    """The file as it was, with everything that was beside it in the repository."""
    where = os.path.dirname(os.path.abspath(path))
    top = _git(where, "rev-parse", "--show-toplevel").decode().strip()
    archive = _git(top, "archive", "--format=tar", revision)
    subprocess.run(["tar", "-x", "-C", folder], input=archive, check=True, capture_output=True)
    return os.path.join(folder, os.path.relpath(os.path.realpath(path), os.path.realpath(top)))


def _git(folder: str, *words: str) -> bytes:
    try:
        return subprocess.run(["git", "-C", folder, *words], check=True, capture_output=True).stdout
    except FileNotFoundError as error:
        raise UrdfkitError("git is not installed") from error
    except subprocess.CalledProcessError as error:
        raise UrdfkitError(f"git {' '.join(words)}: {error.stderr.decode().strip()}") from error


def differences(before: RobotModel, after: RobotModel, allowed: Tolerances) -> list[str]:
    """What differs between two models by more than the tolerances, a sentence each."""
    found: list[str] = []
    if not allowed.links:
        found += _names("link", before.links_by_name, after.links_by_name)
    if not allowed.joints:
        found += _names("joint", before.joints_by_name, after.joints_by_name)
    for name, link in before.links_by_name.items():
        if name in after.links_by_name:
            found += _link_differences(link, after.links_by_name[name], allowed)
    for name, joint in before.joints_by_name.items():
        if name in after.joints_by_name:
            found += _joint_differences(joint, after.joints_by_name[name], allowed)
    return found


def _names(kind: str, before: Iterable[str], after: Iterable[str]) -> list[str]:
    old, new = set(before), set(after)
    gone = [f"{kind} '{name}' is gone" for name in sorted(old - new)]
    return gone + [f"{kind} '{name}' is new" for name in sorted(new - old)]


def _link_differences(before: Link, after: Link, allowed: Tolerances) -> list[str]:
    found: list[str] = []
    old, new = before.mass, after.mass
    if abs(new - old) > allowed.mass * max(abs(old), abs(new)):
        found.append(f"link '{before.name}': mass {old:g} kg became {new:g} kg")
    tensors = [_tensor(before), _tensor(after)]
    scale = max(abs(entry) for tensor in tensors for entry in tensor)
    if _distance(*tensors) > allowed.inertia * scale:
        texts = [", ".join(f"{entry:g}" for entry in tensor) for tensor in tensors]
        found.append(f"link '{before.name}': inertia {texts[0]} became {texts[1]} kg m^2")
    return found


def _tensor(link: Link) -> tuple[float, ...]:
    return link.inertial.tensor.value if link.inertial and link.inertial.tensor else (0.0,) * 6


def _distance(before: Iterable[float], after: Iterable[float]) -> float:
    return sqrt(sum((new - old) ** 2 for old, new in zip(before, after, strict=True)))


def _joint_differences(before: Joint, after: Joint, allowed: Tolerances) -> list[str]:
    name = f"joint '{before.name}'"
    found: list[str] = []
    if before.kind != after.kind:
        found.append(f"{name}: type {before.kind} became {after.kind}")
    moved = _distance(before.origin.position, after.origin.position)
    if moved > allowed.position:
        found.append(f"{name}: its origin moved by {moved:.4g} m")
    axes = [[e for row in joint.origin.rotation for e in row] for joint in (before, after)]
    turned = _distance(*axes) / sqrt(2)  # |R - R'| = sqrt(2) 2 sin(angle / 2)
    if turned > allowed.rotation:
        found.append(f"{name}: its origin turned by {turned:.4g} rad")
    for of in ("position", "velocity", "effort"):
        new_limits = _limits(after, of)
        for key, old_value in _limits(before, of).items():
            new_value = new_limits[key]
            if not _alike(old_value, new_value, allowed.limit):
                found.append(f"{name}: {key} {old_value} became {new_value}")
    return found


def _alike(old: float | None, new: float | None, tolerance: float) -> bool:
    if old is None or new is None:
        return old is new
    return abs(new - old) <= tolerance * max(abs(old), abs(new))
