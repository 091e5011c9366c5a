"""pytest fixtures for projects with robot models.

::

    @pytest.mark.urdf("urdf/arm.urdf.xacro", args={"side": ["left", "right"]})
    def test_arm(robot_model, urdf_report):
        assert_dof(robot_model, 6)
        assert_no_findings(urdf_report)

With the setting ``urdf_files`` in pytest's configuration, each of these files is a test. urdfkit
itself is imported only when a fixture is used.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import product
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from urdfkit.lint.report import Report
    from urdfkit.physics.dynamics.robot import Dynamics
    from urdfkit.physics.verdicts import Simulation
    from urdfkit.robot.assets.mesh_uses import MeshUse
    from urdfkit.robot.model import RobotModel
    from urdfkit.testing import Description

_MARKER = "urdf"
_SEVERITIES = ("error", "warning", "info")
_FILES = pytest.StashKey[set[Path]]()


def pytest_addoption(parser: pytest.Parser) -> None:
    """Add the settings ``urdf_files`` and ``urdf_fail_on``."""
    parser.addini("urdf_files", "URDF and xacro files to test (globs relative to rootdir)", "args")
    parser.addini("urdf_fail_on", "lowest severity that fails such a test", default="warning")


def pytest_configure(config: pytest.Config) -> None:
    """Register the marker, and resolve the settings."""
    config.addinivalue_line(
        "markers",
        "urdf(path, args={}, variant='', variants={}): the model of the fixtures robot_model and "
        "urdf_report, in one variant of urdfkit.toml; "
        "if the value of an argument is a list, the test runs once for each item; "
        "variants are named sets of arguments",
    )
    fail_on = config.getini("urdf_fail_on")
    if fail_on not in _SEVERITIES:
        known = ", ".join(_SEVERITIES)
        raise pytest.UsageError(f"urdf_fail_on: '{fail_on}' is not one of {known}")
    config.stash[_FILES] = {
        path for pattern in config.getini("urdf_files") for path in _matching(config, pattern)
    }


def _matching(config: pytest.Config, pattern: str) -> list[Path]:
    """The files that match a pattern of the setting ``urdf_files``."""
    try:
        paths = list(config.rootpath.glob(pattern))
    except (NotImplementedError, ValueError) as error:
        raise pytest.UsageError(f"urdf_files: '{pattern}': {error}") from error
    if not paths:
        raise pytest.UsageError(f"urdf_files: no file in {config.rootpath} matches '{pattern}'")
    return paths


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    """Parametrize a marked test with its sets of arguments."""
    marker = metafunc.definition.get_closest_marker(_MARKER)
    if marker is None or "marked_urdf" not in metafunc.fixturenames:
        return
    sets = _argument_sets(marker)
    if [name for name, _ in sets] != [""]:
        names, arguments = [name for name, _ in sets], [chosen for _, chosen in sets]
        metafunc.parametrize("marked_urdf", arguments, ids=names, indirect=True)


def _argument_sets(marker: pytest.Mark) -> list[tuple[str, dict[str, str]]]:
    """The sets of arguments of a marker, each with a name."""
    unknown = marker.kwargs.keys() - {"args", "variant", "variants"}
    if unknown or len(marker.args) != 1:
        what = f", not {', '.join(sorted(unknown))}" if unknown else ""
        pytest.fail(
            f"@pytest.mark.urdf takes a path, args, variant and variants{what}", pytrace=False
        )
    sets = []
    for name, variant in (marker.kwargs.get("variants") or {"": {}}).items():
        choices = {**(marker.kwargs.get("args") or {}), **variant}
        lists = [item if isinstance(item, (list, tuple)) else [item] for item in choices.values()]
        for values in product(*lists):
            chosen = dict(zip(choices, map(_as_text, values), strict=True))
            varied = [chosen[key] for key, items in zip(choices, lists, strict=True) if items[1:]]
            sets.append(("-".join([name, *varied] if name else varied), chosen))
    return sets


def _as_text(value: object) -> str:
    """A value as text for the command line of xacro."""
    return str(value).lower() if isinstance(value, bool) else str(value)


@pytest.fixture
def urdf(request: pytest.FixtureRequest) -> Callable[..., Description]:
    """A factory: ``urdf("urdf/arm.urdf.xacro", side="left")`` returns the expanded model.

    Paths are relative to the file of the test, or else to pytest's root directory.
    """

    def make(path: str | Path, /, **arguments: object) -> Description:
        texts = {name: _as_text(value) for name, value in arguments.items()}
        return _description(request, path, texts)

    return make


def _description(
    request: pytest.FixtureRequest, path: str | Path, arguments: dict[str, str], variant: str = ""
) -> Description:
    from urdfkit.testing import Description

    candidates = [request.path.parent / path, request.config.rootpath / path]
    model_path = next((candidate for candidate in candidates if candidate.is_file()), None)
    if model_path is None:
        listed = " nor ".join(dict.fromkeys(map(str, candidates)))
        pytest.fail(f"no such model {listed}", pytrace=False)
    return Description(str(model_path), arguments, variant=variant)


@pytest.fixture
def marked_urdf(request: pytest.FixtureRequest) -> Description:
    """The model of the test's ``urdf`` marker, with one set of arguments."""
    marker = request.node.get_closest_marker(_MARKER)
    if marker is None:
        pytest.fail('mark the test with its model: @pytest.mark.urdf("path")', pytrace=False)
    ((_, arguments), *_) = _argument_sets(marker)
    variant = marker.kwargs.get("variant", "")
    return _description(request, marker.args[0], getattr(request, "param", arguments), variant)


@pytest.fixture
def robot_model(marked_urdf: Description) -> RobotModel:
    """The robot of the ``urdf`` marker, with its links and joints."""
    return marked_urdf.model


@pytest.fixture
def robot_dynamics(marked_urdf: Description) -> Dynamics:
    """The robot of the ``urdf`` marker in Pinocchio: gravity torques, mass matrix, Jacobians.

    The test is skipped if Pinocchio is not installed.
    """
    from urdfkit.core.installation import install_command

    pytest.importorskip("pinocchio", reason=f"needs {install_command('dynamics')}")
    return marked_urdf.dynamics


@pytest.fixture
def robot_meshes(marked_urdf: Description) -> tuple[MeshUse, ...]:
    """The measured meshes of the visuals and collisions.

    The test is skipped if the libraries that measure meshes are not installed.
    """
    from urdfkit.core.libraries import why_unmeasured

    if reason := why_unmeasured():
        pytest.skip(f"meshes are {reason}")
    return marked_urdf.meshes


@pytest.fixture
def urdf_report(marked_urdf: Description) -> Report:
    """The report of ``urdfkit check`` for the model of the ``urdf`` marker."""
    return marked_urdf.report


@pytest.fixture
def check_urdf(urdf: Callable[..., Description]) -> Callable[..., Report]:
    """``check_urdf("urdf/arm.urdf.xacro", side="left")`` fails the test on findings."""
    from urdfkit.testing import assert_no_findings

    def check(path: str | Path, /, **arguments: object) -> Report:
        __tracebackhide__ = True
        report = urdf(path, **arguments).report
        assert_no_findings(report)
        return report

    return check


@pytest.fixture
def simulate(urdf: Callable[..., Description]) -> Callable[..., Simulation]:
    """``simulate("urdf/arm.urdf.xacro", side="left")`` fails the test if the robot misbehaves.

    The checks are those of ``urdfkit simulate``; the test is skipped if MuJoCo is not installed.
    """
    from urdfkit.core.installation import install_command

    pytest.importorskip("mujoco", reason=f"needs {install_command('simulate')}")
    from urdfkit.output.simulation import simulate as simulated

    def run(path: str | Path, /, **arguments: object) -> Simulation:
        __tracebackhide__ = True
        simulation = simulated(urdf(path, **arguments).context)
        if not simulation.passes:
            failures = "\n".join(str(each) for each in simulation.verdicts if not each.passes)
            pytest.fail(failures, pytrace=False)
        return simulation

    return run


def pytest_collect_file(file_path: Path, parent: pytest.Collector) -> UrdfFile | None:
    """Collect the files of the setting ``urdf_files``."""
    if file_path in parent.config.stash[_FILES]:
        return UrdfFile.from_parent(parent, path=file_path)
    return None


class UrdfFile(pytest.File):
    """A model of the setting ``urdf_files``, with a test for each of its variants."""

    def collect(self) -> Iterator[UrdfItem]:
        from urdfkit.testing import variants

        for name in variants(str(self.path)):
            label = f"urdfkit[{name}]" if name else "urdfkit"
            yield UrdfItem.from_parent(self, name=label, variant=name)


class UrdfItem(pytest.Item):
    """The check of a variant of a model; it fails with the report."""

    def __init__(self, variant: str, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.variant = variant

    def runtest(self) -> None:
        from urdfkit.testing import Description, assert_no_findings
        from urdfkit.text.diagnostic import Severity

        report = Description(str(self.path), variant=self.variant).report
        assert_no_findings(report, fail_on=Severity(self.config.getini("urdf_fail_on")))

    def repr_failure(self, excinfo: pytest.ExceptionInfo[BaseException], style: Any = None) -> Any:
        if isinstance(excinfo.value, AssertionError):
            return str(excinfo.value).strip()
        return super().repr_failure(excinfo, style)

    def reportinfo(self) -> tuple[Path, int, str]:
        return self.path, 0, f"{self.path.name}: {self.name}"
