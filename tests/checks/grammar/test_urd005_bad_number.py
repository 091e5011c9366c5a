import pytest

from tests.naming import naming
from tests.reported import fixed, messages, places, reported

BALL = (
    '<link name="a"><visual><origin xyz="{}"/><geometry><sphere radius="{}"/></geometry></visual>'
    "</link>"
)


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("", ["empty"]),
        ("  ", ["empty"]),
        ("0,5", ["decimal comma", "0,5"]),
        ("nan", ["nan", "reject"]),
        ("-Inf", ["-Inf", "reject"]),
        ("1e400", ["1e400", "not a number"]),
        ("5cm", ["5cm", "not a number"]),
        ("0x10", ["0x10", "not a number"]),
        ("1_000", ["1_000", "not a number"]),
        ("\u0661", ["\u0661", "not a number"]),
        ("0.5 ", ["white space after"]),
        ("0.5\n", ["white space after"]),
        ("1 2", ["2", "1"]),
    ],
)
def test_why_a_number_is_none(text: str, why: list[str]) -> None:
    (message,) = messages("URD005", BALL.format("0 0 0", text))
    assert message == naming("a", "radius", "<sphere>", *why)


def test_commas_between_numbers_are_no_decimal_commas() -> None:
    (message,) = messages("URD005", BALL.format("1,2,3", "1"))
    assert message == naming("a", "<origin>")


@pytest.mark.parametrize("text", ["1", "-1.5e-3", "+.5", "2.", "1E+05", " 1", "1e-400", "0"])
def test_what_urdfdom_reads_is_a_number(text: str) -> None:
    assert reported("URD005", BALL.format("0 0 0", text)) == []


@pytest.mark.parametrize(
    ("text", "better"),
    [
        ("0, 0, 0,5", "0 0 0.5"),
        ("0,5 1 1", "0.5 1 1"),
        ("1, 2, 3", "1 2 3"),
        ("1,2,3", "1 2 3"),
        ("1\t2 3", "1 2 3"),
        ("1\n 2\r\n 3", "1 2 3"),
        ("1&#9;2 3", None),  # no text to edit
        ("1,2 3,4", None),
        ("a b c", None),
    ],
)
def test_commas_and_white_space_are_fixed_where_that_is_enough(
    text: str, better: str | None
) -> None:
    robot = BALL.format(text, "1")
    (found,) = reported("URD005", robot)
    assert bool(found.fix) == (better is not None)
    if better:
        assert fixed("URD005", robot) == (
            f'<robot name="example">\n{BALL.format(better, "1")}\n</robot>\n'
        )


def test_a_tab_between_numbers_is_reported_where_it_stands() -> None:
    robot = BALL.format("1\t2 3", "1")
    assert messages("URD005", robot) == [naming("a", "<origin>")]
    assert places("URD005", robot) == [(2, "1\t2 3")]


def test_xacro_writes_spaces_for_tabs() -> None:
    robot = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">{}</robot>'
    assert reported("URD005", robot.format(BALL.format("1\t2 3", "${1}")), "robot.xacro") == []


@pytest.mark.parametrize("text", ["${radius}", "$(arg radius)"])
def test_expressions_are_another_finding(text: str) -> None:
    assert reported("URD005", BALL.format(text, text)) == []


def test_numbers_of_other_families_are_theirs() -> None:
    robot = '<link name="a"/><gazebo reference="a"><mu1 value="x"/></gazebo>'
    assert reported("URD005", robot) == []


VISUAL = (
    '<link name="a"><visual><origin {}/><geometry><mesh filename="a.stl" {}/></geometry>'
    '<material name="m"><color {}/></material></visual></link>'
)
RIGHT = ('xyz="0 0 0"', 'scale="1 1 1"', 'rgba="1 1 1 1"')


@pytest.mark.parametrize(
    ("place", "written", "message"),
    [
        (0, 'xyz="0 0"', naming("a", "<origin>", "2", "3")),
        (0, 'xyz=""', naming("a", "<origin>", "0", "3")),
        (0, 'rpy="0 0 0 1"', naming("a", "<origin>", "4", "3")),
        (1, 'scale="2"', naming("a", "<mesh>", "1", "number", "3")),
        (
            2,
            'rgba="1 1 1"',
            naming("a", "<color>", "3", "4"),
        ),
    ],
)
def test_count_and_bound_are_reported(place: int, written: str, message: str) -> None:
    parts = list(RIGHT)
    parts[place] = written
    assert messages("URD005", VISUAL.format(*parts)) == [message]


def test_any_number_of_spaces_separates() -> None:
    assert reported("URD005", VISUAL.format('xyz="  0  0   0 "', *RIGHT[1:])) == []


@pytest.mark.parametrize(
    ("place", "written", "better"),
    [
        (1, 'scale="0.001"', 'scale="0.001 0.001 0.001"'),
        (2, "rgba='1 0 0'", "rgba='1 0 0 1'"),
        (0, 'xyz="0 0"', 'xyz="0 0"'),  # nobody knows which is missing
        (1, 'scale="1 1"', 'scale="1 1"'),
    ],
)
def test_what_is_surely_meant_is_offered(place: int, written: str, better: str) -> None:
    bad, good = list(RIGHT), list(RIGHT)
    bad[place], good[place] = written, better
    assert fixed("URD005", VISUAL.format(*bad)) == (
        f'<robot name="example">\n{VISUAL.format(*good)}\n</robot>\n'
    )


def test_one_number_scales_a_mesh_in_drake() -> None:
    robot = '<link name="a"><visual><geometry><mesh filename="a.obj" scale="{}"/></geometry>'
    robot += "</visual></link>"
    assert len(reported("URD005", robot.format("0.001"))) == 1
    assert reported("URD005", robot.format("0.001"), targets=("drake",)) == []
    assert len(reported("URD005", robot.format("0.001"), targets=("drake", "ros2"))) == 1
    assert len(reported("URD005", robot.format("1 2"), targets=("drake",))) == 1


def test_a_decimal_comma_in_an_expression() -> None:
    robot = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><link name="a"><inertial>'
    robot += '<mass value="${2*0,9}"/></inertial></link></robot>'
    (found,) = reported("URD005", robot, "robot.xacro")
    assert found.message == naming("a", "<mass>", "(0, 9)", "decimal comma")
    assert "decimal point" in found.help
