from __future__ import annotations

from tests.gazebos import BASE, plugin
from tests.reported import messages, places, reported

MOVE = "libgazebo_ros_planar_move.so"


def test_a_tag_that_is_not_read() -> None:
    text = BASE + plugin(MOVE, "<odometryFrame>odom</odometryFrame><enableYAxis>1</enableYAxis>")
    assert messages("GAZ016", text) == [
        "plugin 'p' (libgazebo_ros_planar_move.so) does not read <enableYAxis>"
    ]
    assert places("GAZ016", text) == [(4, "<enableYAxis>")]


def test_a_block_is_told_once_with_its_path() -> None:
    wheel = '<wheel link_name="base"><wheel_normal_force>1</wheel_normal_force><a><b/></a></wheel>'
    text = BASE + plugin("libWheelSlipPlugin.so", wheel)
    assert messages("GAZ016", text) == [
        "plugin 'p' (libWheelSlipPlugin.so) does not read <a> in <wheel>"
    ]


def test_what_examples_give_without_need_is_left_alone() -> None:
    assert reported("GAZ016", BASE + plugin(MOVE, "<alwaysOn>true</alwaysOn>")) == []


def test_slips_and_other_generations_have_rules_of_their_own() -> None:
    tags = "<odometryFrme>odom</odometryFrme><odometryRate>1</odometryRate>"
    assert reported("GAZ016", BASE + plugin(MOVE, tags)) == []
    assert reported("GAZ016", BASE + plugin(MOVE, tags), targets=("classic-ros2",)) == []
    (found,) = reported("GAZ016", BASE + plugin(MOVE, tags + "<enableYAxis>1</enableYAxis>"))
    assert found.message.endswith("does not read <enableYAxis>")


def test_nothing_is_known_of_what_a_vendor_reads() -> None:
    assert reported("GAZ016", BASE + plugin("libvendor.so", "<anything/>")) == []


def test_free_form_blocks_and_patterns() -> None:
    harness = plugin("libgazebo_ros_harness.so", "<joint name='j'><parent>x</parent></joint>")
    assert reported("GAZ016", BASE + harness) == []
    water = plugin("gz-sim-hydrodynamics-system", "<link_name>base</link_name><xDotU>1</xDotU>")
    assert reported("GAZ016", BASE + water) == []
    qos = "<ros><qos><topic name='a'><subscription><depth>1</depth></subscription></topic></qos>"
    ros = plugin(MOVE, f"{qos}</ros><odometry_frame>o</odometry_frame>")
    assert reported("GAZ016", BASE + ros) == []


def test_a_plugin_of_the_wrong_generation_has_one_defect() -> None:
    text = BASE + plugin(MOVE, "<enableYAxis>1</enableYAxis>")
    assert reported("GAZ016", text, targets=("gz-harmonic",)) == []
