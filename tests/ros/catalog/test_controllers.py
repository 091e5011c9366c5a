"""The facts about controllers hang together."""

from urdfkit.ros.catalog import ros_control
from urdfkit.ros.catalog.controllers import classes, of_manager, parameters_of, successor

KINDS = ("bool", "int", "double", "string")


def test_a_controller_follows_the_documented_fields() -> None:
    for name in classes(2):
        known = parameters_of(name, 2)
        assert known is not None
        assert {kind.removesuffix("_array") for kind in known.types.values()} <= set(KINDS), name
        numbers = {n for n, kind in known.types.items() if kind in KINDS[1:3]}
        assert set(known.positive) <= numbers, name
        required = "|".join(known.required).split("|")
        assert all(map(known.type_of, filter(None, required))), name


def test_joint_parameters_are_strings() -> None:
    shared = classes(2) & ros_control.controller_types().keys()
    assert shared
    for name in shared:
        known = parameters_of(name, 2)
        assert known is not None
        kinds = {known.type_of(joint) for joint in ros_control.controller_types()[name].joints}
        assert kinds <= {"string", "string_array", None}, name


def test_a_wildcard_matches_any_joint() -> None:
    known = parameters_of("joint_trajectory_controller/JointTrajectoryController", 2)
    assert known is not None
    assert known.type_of("constraints.elbow.goal") == "double"
    assert known.type_of("constraints.goal_time") == "double"
    assert known.type_of("constraints.elbow.other") is None


def test_unknown_controllers_and_parameters() -> None:
    assert parameters_of("my_controllers/Mine", 2) is None
    assert successor("my_controllers/Mine") is None


def test_successors_exist_and_replaced_classes_do_not() -> None:
    moved = {name: suggested for name in classes(1) if (suggested := successor(name))}
    assert moved
    assert set(moved).isdisjoint(classes(2))
    assert set(moved.values()) <= set(classes(2))


def test_the_update_rate_is_an_integer() -> None:
    assert of_manager().types == {"update_rate": "int"}
