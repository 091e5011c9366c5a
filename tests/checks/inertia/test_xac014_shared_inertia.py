from pathlib import Path

import pytest

from tests.conftest import MISSION
from tests.massive import BALL, MESH, inertial, joint, link, part, shape
from tests.naming import naming
from tests.reported import messages
from tests.reported import reported as reported_plain
from tests.xacros import reported, told_of, write
from urdfkit.lint import engine

TENSOR = '<inertia ixx="0.1" ixy="0" ixz="0" iyy="0.2" iyz="0" izz="0.3"/>'
MACRO = (
    '<xacro:macro name="inertial" params="mass"><inertial><mass value="${mass}"/>'
    f"{TENSOR}</inertial></xacro:macro>\n"
)


def links(*masses: float) -> str:
    return "\n".join(
        f'<link name="l{number}"><xacro:inertial mass="{mass}"/></link>'
        for number, mass in enumerate(masses)
    )


def test_links_of_different_mass() -> None:
    (found,) = reported("XAC014", MACRO + links(8, 0.5, 0.25))
    assert (found.span.line, found.span.text) == (
        2,
        '<xacro:macro name="inertial" params="mass">',
    )
    assert found.message == naming("inertial", "3", "0.25", "8 kg", "0.1, 0.2, 0.3 kg·m²")
    assert [(one.span.line, one.message) for one in found.related] == [
        (3, naming("l0", "8 kg")),
        (4, naming("l1", "0.5 kg")),
        (5, naming("l2", "0.25 kg")),
    ]


@pytest.mark.parametrize(
    "body",
    [
        MACRO + links(8),
        MACRO + links(0.5, 0.5, 0.51),
        MACRO.replace('"0.1"', '"${mass/2}"') + links(8, 0.5),
        MACRO.replace("0.1", "0").replace("0.2", "0").replace("0.3", "0") + links(8, 0.5),
    ],
    ids=["one call", "alike", "computed", "zero"],
)
def test_no_macro_gives_a_constant_to_different_masses(body: str) -> None:
    assert reported("XAC014", body) == []


@pytest.mark.parametrize(
    ("mass", "found"), [(1.06, 0), (1.19, 0), (1.21, 1)]
)  # HEBI's actuators: 1.06
def test_how_different_in_a_macro(mass: float, found: int) -> None:
    assert len(reported("XAC014", MACRO + links(1, mass))) == found


def test_the_macro_of_an_included_file(tmp_path: Path) -> None:
    write(tmp_path, robot=f'<xacro:include filename="i.xacro"/>{links(1, 2)}', i=MACRO)
    (found,) = told_of("XAC014", tmp_path / "robot.xacro")
    assert Path(found.span.source.path).name == "i.xacro"


def test_the_models_mission() -> None:
    report = engine.check(MISSION, select=["XAC014"])
    (found,) = report.diagnostics
    assert found.message == naming(
        "default_inertial", "6", "0.0001", "8.2 kg", "0.1, 0.1, 0.1 kg·m²"
    )


COPIED = (0.002, 1e-6, 0, 0.002, 0, 0.001)


def test_copies_in_links_of_different_mass() -> None:
    robot = "".join(link(f"l{i}", inertial(mass, COPIED)) for i, mass in enumerate((3, 1, 2)))
    (found,) = reported_plain("XAC014", robot)
    assert found.message == naming("3", "l1", "1 kg", "l0", "3 kg", "0.002, 0.002, 0.001 kg·m²")
    assert found.element == "link/l1/inertial/inertia"
    assert [note.message for note in found.related] == [naming("l0", "3 kg"), naming("l2", "2 kg")]


@pytest.mark.parametrize(("mass", "found"), [(1, 0), (1.4, 0), (1.6, 1)])
def test_how_different(mass: float, found: int) -> None:
    robot = link("a", inertial(1, COPIED)) + link("b", inertial(mass, COPIED))
    assert len(messages("XAC014", robot)) == found
    if found:
        assert messages("XAC014", robot)[0] == naming(
            "2", "a", "1 kg", "b", "1.6 kg", "0.002, 0.002, 0.001 kg·m²"
        )


@pytest.mark.parametrize(
    "robot",
    [
        # INE006 tells it
        part("a", 0.1, (1, 1, 1), BALL) + part("b", 0.5, (1, 1, 1), BALL),
        # INE006 tells it of two, and the others have it too
        part("a", 0.1, (1, 1, 1), BALL)
        + link("b", inertial(1, (1, 1, 1)))
        + link("c", inertial(2, (1, 1, 1))),
        # one is fixed to the world
        link("world")
        + link("a", inertial(1, COPIED))
        + link("b", inertial(2, COPIED))
        + joint("world", "a"),
        # INE009
        link("a", shape("visual", MESH), inertial(1, (1, 1, 1)))
        + link("b", shape("visual", MESH), inertial(2, (1, 1, 1))),
        # INE012
        link("hand")
        + link("left_finger", inertial(1, COPIED))
        + link("right_finger", inertial(2, COPIED))
        + joint("hand", "left_finger")
        + joint("hand", "right_finger"),
        # lost in a larger body
        link("base", inertial(9, (1, 1, 1.1)))
        + link("a", inertial(1, (1e-5, 1e-5, 1e-6)))
        + link("b", inertial(2, (1e-5, 1e-5, 1e-6)))
        + joint("base", "a")
        + joint("base", "b"),
        # nothing to compare
        link("a", inertial(1, (0, 0, 0))) + link("b", inertial(2, (0, 0, 0))),
    ],
)
def test_what_does_not_matter_or_is_another_rule_s(robot: str) -> None:
    assert messages("XAC014", robot) == []
