import pytest

from tests.reported import fixed, messages, places, reported

BALL = (
    '<link name="a"><visual><origin xyz="{}"/><geometry><sphere radius="{}"/></geometry></visual>'
    "</link>"
)


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("", "is empty"),
        ("  ", "is empty"),
        ("0,5", "has a decimal comma ('0,5'); write a decimal point"),
        ("nan", "is 'nan', which URDF parsers reject"),
        ("-Inf", "is '-Inf', which URDF parsers reject"),
        ("1e400", "holds '1e400', which is not a number"),
        ("5cm", "holds '5cm', which is not a number"),
        ("0x10", "holds '0x10', which is not a number"),
        ("1_000", "holds '1_000', which is not a number"),
        ("\u0661", "holds '\u0661', which is not a number"),
        ("0.5 ", "has white space after the number"),
        ("0.5\n", "has white space after the number"),
        ("1 2", "holds 2 numbers, not 1"),
    ],
)
def test_why_a_number_is_none(text: str, why: str) -> None:
    (message,) = messages("URD005", BALL.format("0 0 0", text))
    assert message == f"link 'a': radius of <sphere> {why}"


def test_commas_between_numbers_are_no_decimal_commas() -> None:
    (message,) = messages("URD005", BALL.format("1,2,3", "1"))
    assert message.endswith("xyz of <origin> has commas between its numbers; parsers need spaces")


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
    assert messages("URD005", robot) == [
        (
            "link 'a': xyz of <origin> has a tab or a line break between its numbers; "
            "parsers need spaces"
        )
    ]
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
        (0, 'xyz="0 0"', "link 'a': xyz of <origin> has 2 numbers, not 3 (x y z)"),
        (0, 'xyz=""', "link 'a': xyz of <origin> has 0 numbers, not 3 (x y z)"),
        (0, 'rpy="0 0 0 1"', "link 'a': rpy of <origin> has 4 numbers, not 3 (x y z)"),
        (1, 'scale="2"', "link 'a': scale of <mesh> has 1 number, not 3 (x y z)"),
        (
            2,
            'rgba="1 1 1"',
            "link 'a': rgba of <color> has 3 numbers, not 4 (red green blue alpha)",
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
