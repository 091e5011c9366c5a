from pathlib import Path

from tests.naming import naming
from tests.xacros import codes, reported, told_of, write


def test_one_finding_per_argument_with_its_uses() -> None:
    body = (
        '<link name="$(arg prefix)a"/>\n<link name="$(arg side)b"/>\n<link name="$(arg prefix)c"/>'
    )
    found = reported("XAC010", body)
    assert [(one.span.line, one.span.text, one.message) for one in found] == [
        (2, "$(arg prefix)", naming("prefix", "default")),
        (3, "$(arg side)", naming("side", "default")),
    ]
    assert [(one.span.line, one.message) for one in found[0].related] == [(4, "needed here")]
    assert found[0].help == "pass it: prefix:=VALUE"


def test_the_help_names_the_others_with_their_defaults() -> None:
    body = '<xacro:arg name="side" default="left"/><link name="$(arg prefix)$(arg side)"/>'
    (found,) = reported("XAC010", body)
    assert found.help == naming("prefix:=VALUE", "side", "left")


def test_a_typo_in_what_was_given_is_named() -> None:
    (found,) = reported("XAC010", '<link name="$(arg prefix)a"/>', prefx="b_", other="c")
    assert found.help == "pass it: prefix:=VALUE, not prefx:="


def test_what_follows_from_it_is_not_reported() -> None:
    body = (
        '<xacro:property name="c" value="${xacro.load_yaml(\'$(arg config)/arm.yaml\')}"/>\n'
        "<link name=\"a\"/><origin xyz=\"${c['x']} ${c['y']} 0\"/>\n"
        '<xacro:include filename="$(arg config)/arm.xacro"/><xacro:arm length="${c[\'l\']}"/>'
    )
    assert codes(body) == ["XAC010"]


def test_given_or_with_a_default() -> None:
    assert reported("XAC010", '<link name="$(arg prefix)a"/>', prefix="x") == []
    body = '<xacro:arg name="prefix" default=""/><link name="$(arg prefix)a"/>'
    assert reported("XAC010", body) == []


def test_inside_a_macro_that_is_not_called() -> None:
    assert reported("XAC010", '<xacro:macro name="m"><link name="$(arg x)"/></xacro:macro>') == []


def test_a_default_that_only_stands_in(tmp_path: Path) -> None:
    (tmp_path / "config" / "ur5e").mkdir(parents=True)
    (tmp_path / "config" / "ur5e" / "a.yaml").write_text("x: 1\n")
    load = "${xacro.load_yaml('config/$(arg kind)/%s')['x']}"
    write(
        tmp_path,
        robot=f'<xacro:arg name="kind" default="ur5x"/>\n<link name="a{load % "a.yaml"}"/>\n'
        f'<link name="b{load % "b.yaml"}"/>',
    )
    (found,) = told_of("XAC010", tmp_path / "robot.xacro")
    assert (found.span.line, found.span.text) == (2, "ur5x")
    assert found.message == naming("kind", "ur5x", "missing")
    assert told_of("XAC001", tmp_path / "robot.xacro") == []
    (tmp_path / "config" / "ur5e" / "b.yaml").write_text("x: 1\n")
    for arguments in ({"kind": "ur5e"}, {}):  # a directory in which all files are there is a value
        assert told_of("XAC010", tmp_path / "robot.xacro", **arguments) == []
        assert told_of("XAC001", tmp_path / "robot.xacro", **arguments) == []


def test_an_absolute_default_that_only_stands_in(tmp_path: Path) -> None:
    """Pioneer of TU Wien: models_dir is /tmp, which exists, unless the launch file passes it."""
    write(
        tmp_path,
        robot=f'<xacro:arg name="models" default="{tmp_path}"/>\n'
        '<xacro:arg name="kind" default="rover"/>\n'
        '<xacro:include filename="$(arg models)/$(arg kind)/body.xacro"/><link name="a"/>',
    )
    (found,) = told_of("XAC010", tmp_path / "robot.xacro")
    assert (found.span.line, found.span.text) == (2, str(tmp_path))


def test_a_path_that_is_empty_unless_given(tmp_path: Path) -> None:
    """Motoman's ``es165`` reads velocities from the file that a launch file chooses."""
    write(
        tmp_path,
        robot='<xacro:arg name="speeds" default=""/><xacro:property name="file" '
        """value="$(arg speeds)"/><link name="a${xacro.load_yaml(file)['x']}"/>""",
    )
    (found,) = told_of("XAC010", tmp_path / "robot.xacro")
    assert found.message == naming("speeds", "", "missing")
    assert told_of("XAC001", tmp_path / "robot.xacro") == []
    (tmp_path / "a.yaml").write_text("x: 1\n")
    assert told_of("XAC010", tmp_path / "robot.xacro", speeds="a.yaml") == []


def test_a_default_that_only_stands_in_for_the_file_to_include(tmp_path: Path) -> None:
    """Kinova's ``arm`` is ``NO_ARM_TYPE_DEFINED`` unless given, and part of the path of a macro."""
    write(
        tmp_path,
        robot='<xacro:arg name="arm" default="NO_ARM"/>\n'
        '<xacro:macro name="load" params="arm"><xacro:include filename="arms/${arm}/arm.xacro"/>'
        '</xacro:macro>\n<xacro:load arm="$(arg arm)"/>',
    )
    (tmp_path / "arms").mkdir()
    (found,) = told_of("XAC010", tmp_path / "robot.xacro")
    assert (found.span.line, found.span.text) == (2, "NO_ARM")
    assert told_of("XAC001", tmp_path / "robot.xacro") == []
    (tmp_path / "arms" / "NO_ARM").mkdir()  # the default is right, and a file is missing
    assert told_of("XAC010", tmp_path / "robot.xacro") == []
    assert [one.span.line for one in told_of("XAC001", tmp_path / "robot.xacro")] == [3]


def test_a_default_that_needs_the_argument_itself() -> None:
    body = '<link name="$(arg a)"/>\n<xacro:arg name="a" default="$(arg a)"/>'
    (message,) = {one.message for one in reported("XAC010", body)}
    assert message == naming("a", "default")
    body = (
        '<xacro:arg name="a" default="$(arg b)"/>\n<xacro:arg name="b" default="$(arg a)"/>\n'
        '<link name="$(arg b)"/>'
    )
    assert reported("XAC010", body)
