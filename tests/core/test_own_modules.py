"""urdfkit's own modules are found as Python finds them."""

import pkgutil
from importlib.machinery import PathFinder

import pytest

import urdfkit
from urdfkit.core.own_modules import OwnModules


def test_it_finds_what_python_finds() -> None:
    found = list(pkgutil.walk_packages(urdfkit.__path__[:1], "urdfkit."))
    assert len(found) > 800
    for module in found:
        path = [module.module_finder.path]  # type: ignore[union-attr]
        ours = OwnModules.find_spec(module.name, path)
        theirs = PathFinder.find_spec(module.name, path)
        assert ours is not None
        assert theirs is not None
        for key in ("origin", "cached", "has_location", "submodule_search_locations", "parent"):
            assert getattr(ours, key) == getattr(theirs, key), module.name


@pytest.mark.parametrize("name", ["urdfkit", "json", "urdfkit.nothing", "urdfkit_new.a"])
def test_others_find_the_rest(name: str) -> None:
    path = urdfkit.__path__ if "." in name else None
    assert OwnModules.find_spec(name, path) is None
