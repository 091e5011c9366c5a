"""The facts about the children of ``<gazebo>`` hang together."""

import pytest

from urdfkit.ros.catalog import data, extensions, plugins


def test_a_tag_follows_the_documented_fields() -> None:
    types = ("float", "int", "bool", "vector3", "string", "container", "any")
    for tag, extension in extensions.extensions().items():
        assert extension.tag == tag
        assert extension.on in ("link", "joint", "model", "any"), tag
        assert extension.type in types, tag
        assert (extension.words in ("yes", "no")) is (extension.type == "bool"), tag


def test_suggested_names_are_handled_and_wrong_names_are_not() -> None:
    handled = extensions.extensions()
    assert set(extensions.suggested()).isdisjoint(handled)
    assert set(extensions.suggested().values()) <= set(handled)


@pytest.mark.parametrize("kind", ["link", "joint", "model", "visual", "collision"])
def test_children_of_sdf_are_sorted_and_unique(kind: str) -> None:
    children = extensions.copied(kind)
    assert children == sorted(set(children))


def test_rewritten_parameters_are_read_by_a_plugin() -> None:
    read = {name for plugin in plugins.all_plugins() for name in plugin.parameters}
    assert set(extensions.rewritten()) <= read


def test_the_file_names_its_source() -> None:
    assert "parser_urdf.cc" in data("extensions")["source"]
