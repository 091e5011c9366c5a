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

from collections.abc import Callable, Iterator, Mapping
from itertools import product
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from urdfkit.diagnostic import Report
    from urdfkit.model import RobotModel
    from urdfkit.testing import Description

_MARKER = "urdf"


def pytest_addoption(parser: pytest.Parser) -> None:
    """The settings ``urdf_files`` and ``urdf_fail_on``."""
    parser.addini("urdf_files", "URDF and xacro files (globs) that are tests themselves", "args")
    parser.addini("urdf_fail_on", "mildest finding that fails such a test", default="warning")


def pytest_configure(config: pytest.Config) -> None:
    """Make the marker known."""
    config.addinivalue_line(
        "markers",
        "urdf(path, args={}, variants={}): the model that robot_model and urdf_report are of; "
        "a list as the value of an argument runs the test once for each of its items, and "
        "variants are named sets of arguments",
    )


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    """Run a marked test once for every set of arguments."""
    marker = metafunc.definition.get_closest_marker(_MARKER)
    if marker is None or "marked_urdf" not in metafunc.fixturenames:
        return
    sets = dict(_argument_sets(**marker.kwargs))
    if len(sets) > 1:
        metafunc.parametrize("marked_urdf", list(sets.values()), ids=list(sets), indirect=True)


def _argument_sets(
    args: Mapping[str, Any] | None = None, variants: Mapping[str, Mapping[str, Any]] | None = None
) -> Iterator[tuple[str, dict[str, str]]]:
    """The sets of arguments that a marker means, each with a name."""
    for name, variant in (variants or {"": {}}).items():
        every = {**(args or {}), **variant}
        lists = [value if isinstance(value, (list, tuple)) else [value] for value in every.values()]
        for values in product(*lists):
            chosen = dict(zip(every, map(_as_text, values), strict=True))
            varied = [chosen[key] for key, choice in zip(every, lists, strict=True) if choice[1:]]
            yield "-".join([name, *varied] if name else varied), chosen


def _as_text(value: object) -> str:
    """A value as the command line of xacro would give it."""
    return str(value).lower() if isinstance(value, bool) else str(value)


@pytest.fixture
def urdf(request: pytest.FixtureRequest) -> Callable[..., Description]:
    """A factory: ``urdf("urdf/arm.urdf.xacro", side="left")`` is that model, expanded.

    Paths are relative to the test's file, else to pytest's root folder.
    """
    from urdfkit.testing import Description

    def make(path: str, **arguments: object) -> Description:
        texts = {name: _as_text(value) for name, value in arguments.items()}
        return Description(_find(request, path), texts)

    return make


def _find(request: pytest.FixtureRequest, path: str) -> str:
    beside = request.path.parent / path
    return str(beside if beside.exists() else request.config.rootpath / path)


@pytest.fixture
def marked_urdf(request: pytest.FixtureRequest) -> Description:
    """The model of the test's ``urdf`` marker, with one set of its arguments."""
    from urdfkit.testing import Description

    marker = request.node.get_closest_marker(_MARKER)
    if marker is None or len(marker.args) != 1:
        raise pytest.UsageError('mark the test with its model: @pytest.mark.urdf("path")')
    sets = dict(_argument_sets(**marker.kwargs))
    arguments = getattr(request, "param", None) or next(iter(sets.values()))
    return Description(_find(request, marker.args[0]), arguments)


@pytest.fixture
def robot_model(marked_urdf: Description) -> RobotModel:
    """The robot of the ``urdf`` marker: links, joints and what they hold."""
    return marked_urdf.model


@pytest.fixture
def urdf_report(marked_urdf: Description) -> Report:
    """What ``urdfkit check`` says about the model of the ``urdf`` marker."""
    return marked_urdf.report


@pytest.fixture
def check_urdf(urdf: Callable[..., Description]) -> Callable[..., Report]:
    """``check_urdf("urdf/arm.urdf.xacro", side="left")`` fails the test on findings."""
    from urdfkit.testing import assert_no_findings

    def check(path: str, **arguments: object) -> Report:
        report = urdf(path, **arguments).report
        assert_no_findings(report)
        return report

    return check


def pytest_collect_file(file_path: Path, parent: pytest.Collector) -> UrdfFile | None:
    """Make the files of the setting ``urdf_files`` tests."""
    patterns = parent.config.getini("urdf_files")
    root = parent.config.rootpath
    if not patterns or not file_path.is_relative_to(root):
        return None
    relative = file_path.relative_to(root)
    if any(relative.match(pattern) or relative.as_posix() == pattern for pattern in patterns):
        return UrdfFile.from_parent(parent, path=file_path)
    return None


class UrdfFile(pytest.File):
    """A model of the setting ``urdf_files``, with a test for each of its variants."""

    def collect(self) -> Iterator[UrdfItem]:
        from urdfkit.testing import variants

        for name, arguments in variants(str(self.path)):
            label = f"urdfkit[{name}]" if name else "urdfkit"
            yield UrdfItem.from_parent(self, name=label, arguments=arguments)


class UrdfItem(pytest.Item):
    """A check of one model; it fails with the report."""

    def __init__(self, arguments: dict[str, str], **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.arguments = arguments

    def runtest(self) -> None:
        from urdfkit.diagnostic import Severity
        from urdfkit.testing import Description, assert_no_findings

        report = Description(str(self.path), self.arguments).report
        assert_no_findings(report, fail_on=Severity(self.config.getini("urdf_fail_on")))

    def repr_failure(self, excinfo: pytest.ExceptionInfo[BaseException], style: Any = None) -> Any:
        if isinstance(excinfo.value, AssertionError):
            return str(excinfo.value)
        return super().repr_failure(excinfo, style)

    def reportinfo(self) -> tuple[Path, int, str]:
        return self.path, 0, f"{self.path.name}: {self.name}"
