import importlib.util
import sys
from pathlib import Path

import pytest

from urdfkit.core import libraries


@pytest.mark.parametrize("name", ["json", "numpy", "no_such_library_of_ours"])
def test_what_is_installed_is_what_importlib_finds(name: str) -> None:
    found = libraries.find(name)
    assert (found is None) is (importlib.util.find_spec(name) is None)


def test_all_packages_with_a_name_are_found_in_the_order_of_the_path(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("one", "two"):
        (tmp_path / name / "a_package").mkdir(parents=True)
        (tmp_path / name / "a_package" / "__init__.py").touch()
    (tmp_path / "no_code" / "a_package").mkdir(parents=True)
    monkeypatch.setattr(sys, "path", [str(tmp_path / n) for n in ("no_code", "two", "one")])
    found = [spec.origin for spec in libraries.find_all("a_package")]
    assert found == [str(tmp_path / n / "a_package" / "__init__.py") for n in ("two", "one")]
    assert list(libraries.find_all("no_such_package")) == []
