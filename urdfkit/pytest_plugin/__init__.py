"""pytest fixtures for projects that hold robot models.

::

    @pytest.mark.urdf("urdf/arm.urdf.xacro", args={"side": ["left", "right"]})
    def test_arm(robot_model, urdf_report):
        assert_dof(robot_model, 6)
        assert_no_findings(urdf_report)

The setting ``urdf_files`` in pytest's configuration makes every file it names a test of its own.
urdfkit itself is imported only when a fixture is used.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import product
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from urdfkit.lint.report import Report
    from urdfkit.output.simulation.verdicts import Simulation
    from urdfkit.physics.dynamics.robot import Dynamics
    from urdfkit.robot.assets.mesh_uses import MeshUse
    from urdfkit.robot.model import RobotModel
    from urdfkit.testing import Description

_MARKER = "urdf"
_SEVERITIES = ("error", "warning", "info")
_FILES = pytest.StashKey[set[Path]]()


def pytest_addoption(parser: pytest.Parser) -> None:
    """The settings ``urdf_files`` and ``urdf_fail_on``."""
    parser.addini("urdf_files", "URDF and xacro files to test (globs relative to rootdir)", "args")
    parser.addini("urdf_fail_on", "lowest severity that fails such a test", default="warning")


def pytest_configure(config: pytest.Config) -> None:
    """Make the marker known."""
    config.addinivalue_line(
        "markers",
        "urdf(path, args={}, variant='', variants={}): the model that robot_model and urdf_report "
        "are of, in one variant of urdfkit.toml; "
        "a list as the value of an argument runs the test once for each of its items, and "
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
    """The files that a pattern of the setting ``urdf_files`` means."""
    try:
        found = list(config.rootpath.glob(pattern))
    except (NotImplementedError, ValueError) as error:
        raise pytest.UsageError(f"urdf_files: '{pattern}': {error}") from error
    if not found:
        raise pytest.UsageError(f"urdf_files: no file in {config.rootpath} matches '{pattern}'")
    return found


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    """Run a marked test once for every set of arguments."""
    marker = metafunc.definition.get_closest_marker(_MARKER)
    if marker is None or "marked_urdf" not in metafunc.fixturenames:
        return
    sets = _argument_sets(marker)
    if [name for name, _ in sets] != [""]:
        names, arguments = [name for name, _ in sets], [chosen for _, chosen in sets]
        metafunc.parametrize("marked_urdf", arguments, ids=names, indirect=True)


def _argument_sets(marker: pytest.Mark) -> list[tuple[str, dict[str, str]]]:
    """The sets of arguments that a marker means, each with a name."""
    wrong = marker.kwargs.keys() - {"args", "variant", "variants"}
    if wrong or len(marker.args) != 1:
        what = f", not {', '.join(sorted(wrong))}" if wrong else ""
        pytest.fail(
            f"@pytest.mark.urdf takes a path, args, variant and variants{what}", pytrace=False
        )
    sets = []
    for name, variant in (marker.kwargs.get("variants") or {"": {}}).items():
        every = {**(marker.kwargs.get("args") or {}), **variant}
        lists = [value if isinstance(value, (list, tuple)) else [value] for value in every.values()]
        for values in product(*lists):
            chosen = dict(zip(every, map(_as_text, values), strict=True))
            varied = [chosen[key] for key, choice in zip(every, lists, strict=True) if choice[1:]]
            sets.append(("-".join([name, *varied] if name else varied), chosen))
    return sets


def _as_text(value: object) -> str:
    """A value as the command line of xacro would give it."""
    return str(value).lower() if isinstance(value, bool) else str(value)


@pytest.fixture
def urdf(request: pytest.FixtureRequest) -> Callable[..., Description]:
    """A factory: ``urdf("urdf/arm.urdf.xacro", side="left")`` is that model, expanded.

    Paths are relative to the test's file, else to pytest's root directory.
    """

    def make(path: str | Path, /, **arguments: object) -> Description:
        texts = {name: _as_text(value) for name, value in arguments.items()}
        return _description(request, path, texts)

    return make


def _description(
    request: pytest.FixtureRequest, path: str | Path, arguments: dict[str, str], variant: str = ""
) -> Description:
    from urdfkit.testing import Description

    places = [request.path.parent / path, request.config.rootpath / path]
    found = next((place for place in places if place.is_file()), None)
    if found is None:
        reported = " nor ".join(dict.fromkeys(map(str, places)))
        pytest.fail(f"no such model {reported}", pytrace=False)
    return Description(str(found), arguments, variant=variant)


@pytest.fixture
def marked_urdf(request: pytest.FixtureRequest) -> Description:
    """The model of the test's ``urdf`` marker, with one set of its arguments."""
    marker = request.node.get_closest_marker(_MARKER)
    if marker is None:
        pytest.fail('mark the test with its model: @pytest.mark.urdf("path")', pytrace=False)
    ((_, arguments), *_) = _argument_sets(marker)
    variant = marker.kwargs.get("variant", "")
    return _description(request, marker.args[0], getattr(request, "param", arguments), variant)


@pytest.fixture
def robot_model(marked_urdf: Description) -> RobotModel:
    """The robot of the ``urdf`` marker: links, joints and what they hold."""
    return marked_urdf.model


@pytest.fixture
def robot_dynamics(marked_urdf: Description) -> Dynamics:
    """The same robot in Pinocchio: gravity torques, mass matrix, Jacobians.

    The test is skipped where Pinocchio is not installed.
    """
    from urdfkit.core.installation import install_command

    pytest.importorskip("pinocchio", reason=f"needs {install_command('dynamics')}")
    return marked_urdf.dynamics


@pytest.fixture
def robot_meshes(marked_urdf: Description) -> tuple[MeshUse, ...]:
    """The meshes in its visuals and collisions: where each is used, and its measures.

    The test is skipped where the libraries that measure them are not installed.
    """
    from urdfkit.core.libraries import why_unmeasured

    if reason := why_unmeasured():
        pytest.skip(f"meshes are {reason}")
    return marked_urdf.meshes


@pytest.fixture
def urdf_report(marked_urdf: Description) -> Report:
    """What ``urdfkit check`` says about the model of the ``urdf`` marker."""
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

    What ``urdfkit simulate`` finds; the test is skipped where MuJoCo is not installed.
    """
    from urdfkit.core.installation import install_command

    pytest.importorskip("mujoco", reason=f"needs {install_command('simulate')}")
    from urdfkit.output.simulation import simulate as simulated

    def run(path: str | Path, /, **arguments: object) -> Simulation:
        __tracebackhide__ = True
        found = simulated(urdf(path, **arguments).context)
        if not found.passes:
            failures = "\n".join(str(one) for one in found.verdicts if not one.passes)
            pytest.fail(failures, pytrace=False)
        return found

    return run


def pytest_collect_file(file_path: Path, parent: pytest.Collector) -> UrdfFile | None:
    """Make the files of the setting ``urdf_files`` tests."""
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
    """A check of one model; it fails with the report."""

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
