import importlib.util

import pytest

from urdfkit.core import libraries


@pytest.mark.parametrize("name", ["json", "numpy", "no_such_library_of_ours"])
def test_what_is_installed_is_what_importlib_finds(name: str) -> None:
    found = libraries.find(name)
    assert (found is None) is (importlib.util.find_spec(name) is None)
