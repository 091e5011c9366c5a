"""Robots that gain energy."""

import pytest

pytest.importorskip("mujoco")

from tests.naming import values
from tests.simulated import codes, simulated
from urdfkit.checks.simulation.sim001_unstable import BAD
from urdfkit.text.diagnostic import Severity


def test_overlapping_links_throw_the_robot() -> None:
    (found,) = simulated(BAD)
    assert (found.code, found.severity) == ("SIM001", Severity.ERROR)
    assert "gains 7" in found.message
    assert values(found.message)[-2:] == ["left", "right"]
    assert (found.span.line, found.span.text) == (8, "<collision>")


def test_what_an_overlap_hardly_moves_is_left_to_the_rule_about_overlaps() -> None:
    """Boxes of a fifth of the size are lifted by less than 0.3 of it."""
    small = BAD.replace("0.5 0.5 0.5", "0.1 0.1 0.1").replace('xyz="0.1 0 0"', 'xyz="0.02 0 0"')
    assert codes(small) == []
    pytest.importorskip("coal")
    assert codes(small, "SIM", "COL001") == ["COL001"]


def test_damping_that_drives_is_left_to_the_rule_about_it() -> None:
    apart = BAD.replace('xyz="0.1 0 0"', 'xyz="0.6 0 0"')
    driven = apart.replace("<axis", '<dynamics damping="-1"/><axis', 1)
    assert codes(driven, "SIM", "JNT008") == ["JNT008"]


def test_the_place_is_that_of_the_macro_call(tmp_path) -> None:
    import urdfkit
    from urdfkit.lint.options import Options

    file = tmp_path / "r.urdf.xacro"
    file.write_text(
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">\n<link name="world"/>\n'
        '<xacro:macro name="box" params="name x"><link name="${name}"><inertial><mass value="50"/>'
        '<inertia ixx="2" ixy="0" ixz="0" iyy="2" iyz="0" izz="2"/></inertial>\n<collision>'
        '<geometry><box size="0.5 0.5 0.5"/></geometry></collision></link><joint name="${name}" '
        'type="prismatic"><parent link="world"/><child link="${name}"/><origin xyz="${x} 0 0"/>'
        '<axis xyz="1 0 0"/><limit lower="-3" upper="3" effort="100" velocity="1"/></joint>'
        '</xacro:macro>\n<xacro:box name="left" x="0"/>\n<xacro:box name="right" x="0.1"/>'
        "</robot>"
    )
    report = urdfkit.check(file, select=["SIM001"], options=Options(simulate=urdfkit.simulate))
    (found,) = report.diagnostics
    assert found.span.line == 4
    assert [step.span.line for call in found.calls for step in call.via] == [5]
