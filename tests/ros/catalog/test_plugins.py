"""The facts about plugins hang together, and are found by every name that Gazebo accepts."""

import json
import re
from pathlib import Path

import jsonschema  # type: ignore[import-untyped, unused-ignore]
import pytest

from urdfkit.ros.catalog import data, plugins

DIRECTORY = Path(plugins.__file__).parent
SCHEMA = data("gazebo_plugins.schema")
FILES = sorted((DIRECTORY / "gazebo_plugins").iterdir())
GENERATIONS = {name for names in plugins.GENERATIONS.values() for name in names}


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_a_file_follows_the_schema(file: Path) -> None:
    content = json.loads(file.read_bytes())
    jsonschema.Draft202012Validator.check_schema(SCHEMA)
    jsonschema.Draft202012Validator(SCHEMA).validate(content)
    assert (file.parent / content["$schema"]).resolve() == DIRECTORY / "gazebo_plugins.schema.json"
    assert content["generation"].replace("-", "_") == file.stem


def test_each_generation_has_a_file() -> None:
    assert {data(f"gazebo_plugins/{file.stem}")["generation"] for file in FILES} == GENERATIONS


def test_a_plugin_follows_the_documented_fields() -> None:
    for plugin in plugins.all_plugins():
        assert f"@{plugin.generation}" in plugin.id
        assert bool(plugin.kinds) is not plugin.removed, plugin.id
        assert all(name == parameter.name for name, parameter in plugin.parameters.items())
        assert set(plugin.any_of) <= set(plugin.parameters), plugin.id
        assert all(re.compile(pattern) for pattern in plugin.patterns)
        assert bool(plugin.class_name) <= (plugin.generation == "gz"), plugin.id


def test_defaults_have_the_declared_type() -> None:
    for plugin in plugins.all_plugins():
        for parameter in plugin.parameters.values():
            if parameter.default is not None and parameter.words and parameter.type == "string":
                assert parameter.default in parameter.words, plugin.id
            if parameter.default is not None and parameter.type == "bool":
                assert parameter.default in ("true", "false"), plugin.id


def test_every_successor_exists_in_another_generation() -> None:
    for plugin in plugins.all_plugins():
        if plugin.successor is not None:
            successors = [one for one in plugins.find(plugin.successor) if not one.removed]
            assert [one for one in successors if one.id != plugin.id], plugin.id


def test_ids_and_classes_of_a_file_are_unique() -> None:
    everything = plugins.all_plugins()
    assert len({plugin.id for plugin in everything}) == len(everything) == 197
    for file in plugins.files():
        found = [(plugin.generation, plugin.class_name) for plugin in plugins.find(file)]
        assert len(found) == len(set(found)), file


def test_renamed_tags_are_read_by_a_plugin_of_ros2() -> None:
    read = {
        name
        for plugin in plugins.all_plugins()
        if plugin.generation == "classic-ros2"
        for name in plugin.parameters
    }
    old = {
        name
        for plugin in plugins.all_plugins()
        if plugin.generation == "classic-ros1"
        for name in plugin.parameters
    }
    renames = plugins.renames()
    assert set(renames) <= old
    assert set(renames.values()) <= read


@pytest.mark.parametrize(
    ("filename", "plugin"),
    [
        ("libgazebo_ros_diff_drive.so", "gazebo_ros_diff_drive@classic-ros1"),
        ("gz-sim-diff-drive-system", "gz-sim-diff-drive-system@gz"),
        ("gz-sim8-diff-drive-system", "gz-sim-diff-drive-system@gz"),
        ("libgz-sim-diff-drive-system.so", "gz-sim-diff-drive-system@gz"),
        ("/opt/ros/lib/libgz-sim8-diff-drive-system.so", "gz-sim-diff-drive-system@gz"),
        ("ignition-gazebo6-diff-drive-system", "gz-sim-diff-drive-system@gz"),
        ("libignition-gazebo-diff-drive-system", "gz-sim-diff-drive-system@gz"),
        ("gz_ros2_control-system.so", "gz_ros2_control-system@gz"),
    ],
)
def test_file_names_that_gazebo_accepts(filename: str, plugin: str) -> None:
    assert plugin in [found.id for found in plugins.find(filename)]


@pytest.mark.parametrize("filename", ["gazebo_ros_diff_drive", "libvendor.so", "", "gz-sim-"])
def test_an_unknown_file_name(filename: str) -> None:
    assert plugins.find(filename) == ()


def test_tags_that_a_plugin_reads() -> None:
    (drive,) = (p for p in plugins.find("libgazebo_ros_diff_drive.so") if "ros2" in p.id)
    assert drive.reads("left_joint")
    assert drive.reads("ros")
    assert drive.reads("ros/namespace")
    assert not drive.reads("leftJoint")
    (mistake,) = plugins.find("libWheelSlipPlugin.so")
    assert mistake.reads("wheel")
    assert mistake.reads("wheel/@link_name")
    assert not mistake.reads("wheel/radius")
    (harness,) = (p for p in plugins.find("libgazebo_ros_harness.so") if "ros1" in p.id)
    assert harness.reads("joint/parent"), "a free-form block"
    (hydrodynamics,) = plugins.find("gz-sim-hydrodynamics-system")
    assert hydrodynamics.reads("xDotU")
    assert not hydrodynamics.reads("xDotA")


def test_each_file_name_finds_its_plugins() -> None:
    having = {
        file: [p for p in plugins.all_plugins() if file in (*p.files, *p.fortress_files)]
        for file in plugins.files()
    }
    assert {file: list(plugins.find(file)) for file in plugins.files()} == having
