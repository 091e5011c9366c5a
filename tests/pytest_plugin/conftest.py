"""A project to run pytest in."""

import importlib.util

import pytest

from tests.conftest import ARM, ROOT
from tests.pytest_plugin.projects import Project
from urdfkit.core.libraries import missing_for_meshes
from urdfkit.testing import Description


@pytest.fixture(scope="session")
def _imported() -> None:
    """A run in this process forgets the modules that it imports: here, none is left to import."""
    arm = Description(str(ARM), {})
    assert arm.report.rules
    if importlib.util.find_spec("pinocchio"):
        assert arm.dynamics.columns
    if not missing_for_meshes():
        assert arm.meshes


@pytest.fixture
def project(_imported: None, pytester: pytest.Pytester, monkeypatch: pytest.MonkeyPatch) -> Project:
    monkeypatch.setenv("PYTHONPATH", str(ROOT))
    for name in ("PYTEST_ADDOPTS", "PYTEST_PLUGINS"):
        monkeypatch.delenv(name, raising=False)
    return Project(pytester)
