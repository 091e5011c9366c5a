"""The facts about ros_control hang together."""

import pytest

from urdfkit.ros.catalog import data, plugins, ros_control


def test_tags_and_their_children_are_described() -> None:
    tags = ros_control.grammar()
    assert {name for name, tag in tags.items() if "name" in tag.required} == set(tags) - {
        "hardware"
    }
    without_tags_of_their_own = {
        *("plugin", "group", "limits", "properties", "actuator"),
        "ec_module",  # of the EtherCAT driver
    }
    children = {child for tag in tags.values() for child in tag.children}
    assert children - set(tags) == without_tags_of_their_own
    for tag in tags.values():
        assert tag.required <= {*tag.attributes, *tag.children}
        assert len(set(tag.attributes)) == len(tag.attributes)
        assert len(set(tag.children)) == len(tag.children)


def test_later_additions_are_part_of_the_grammar() -> None:
    for place, distribution in data("ros_control")["since"].items():
        kind = "@" if "@" in place else "/"
        tag, _, name = place.partition(kind)
        found = ros_control.grammar()[tag]
        assert name in (found.attributes if kind == "@" else found.children)
        assert distribution in data("ros_control")["mimic"]
        assert ros_control.since(tag, kind + name) == distribution
    assert ros_control.since("joint", "/param") == ""


def test_hardware_and_control_plugins_refer_to_each_other() -> None:
    loads = ros_control.control_plugin_libraries()
    for name, hardware in ros_control.simulated_hardware().items():
        assert hardware.name == name
        assert hardware.control in loads
        assert set(hardware.commands) >= {"position", "velocity", "effort"}
    for name, file in loads.items():
        assert ros_control.control_plugin(file) == name
        assert plugins.find(file), "the catalogue of plugins has it, too"


@pytest.mark.parametrize(
    ("filename", "plugin"),
    [
        ("libgazebo_ros_control.so", "gazebo_ros_control"),
        ("gazebo_ros2_control", "gazebo_ros2_control"),
        ("/opt/ros/jazzy/lib/libgz_ros2_control-system.so", "gz_ros2_control"),
        ("ign_ros2_control-system", "gz_ros2_control"),
        ("libgazebo_ros_diff_drive.so", None),
        ("", None),
    ],
)
def test_control_plugins_by_file_name(filename: str, plugin: str | None) -> None:
    assert ros_control.control_plugin(filename) == plugin


def test_measures_reference_joint_parameters() -> None:
    sides = {"radius": 1, "track": 1, "separation": 2, "wheelbase": 2, "projection": 2}
    for name, controller in ros_control.controller_types().items():
        assert name.count("/") == 1
        assert controller.joints
        assert len(set(controller.joints)) == len(controller.joints)
        for measure in controller.measures:
            assert len(measure.sides) == sides[measure.kind]
            assert {joint for side in measure.sides for joint in side} <= set(controller.joints)
        parameters = [measure.parameter for measure in controller.measures]
        assert len(set(parameters)) == len(parameters)


def test_words_are_unique() -> None:
    kinds = {
        "transmission": ("types", "interfaces", "gazebo", "unprefixed"),
        "interfaces": ("joint", "imu", "force_torque"),
    }
    for subject, names in kinds.items():
        assert set(data("ros_control")[subject]) == set(names)
        for name in names:
            words = ros_control.words(subject, name)
            assert words
            assert len(set(words)) == len(words)
    interfaces = ros_control.words("transmission", "interfaces")
    assert set(ros_control.words("transmission", "gazebo")) <= set(interfaces)
    assert {
        f"hardware_interface/{word}" for word in ros_control.words("transmission", "unprefixed")
    } == set(ros_control.words("transmission", "gazebo"))
    assert ros_control.component_types() == ["system", "actuator", "sensor"]


def test_facts_have_sources_and_documented_fields() -> None:
    content = data("ros_control")
    assert len(content["sources"]) >= 5
    assert set(content) - {"about", "sources"} - {"since"} == set(content["about"]) - {"since"}
