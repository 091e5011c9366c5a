"""The document of a report, and its forms but the HTML."""

import csv
import io
import json
from pathlib import Path

import pytest

from tests.conftest import ARM
from tests.shipped import GRIPPER, MISSION
from urdfkit.errors import UnreadableFile, UnreadableRobot, UrdfkitError
from urdfkit.lint.engine import check
from urdfkit.lint.loading import read
from urdfkit.lint.options import Options
from urdfkit.output.report.document import describe
from urdfkit.output.report.findings import excerpt
from urdfkit.output.report.writing import form_of, report
from urdfkit.text.source import Source, Span


def test_a_robot_as_a_whole() -> None:
    document, context, _ = describe(GRIPPER)
    robot = document["robot"]
    assert (robot["links"], robot["joints"], robot["degrees_of_freedom"]) == (4, 3, 1)
    assert robot["size"] == pytest.approx([0.08, 0.16, 0.105])
    assert robot["mass"] == pytest.approx(context.model.mass)
    assert [link["name"] for link in document["links"]] == [x.name for x in context.model.links]
    assert sum(link["share"] for link in document["links"]) == pytest.approx(1)
    follower = document["joints"][2]
    assert follower["mimic"]["joint"] == "left_finger_joint"


def test_the_verdict_of_each_program_is_its_own() -> None:
    document, *_ = describe(MISSION)
    assert [target["name"] for target in document["targets"]] == ["ros1", "classic-ros1"]
    assert {target["verdict"] for target in document["targets"]} == {"fails"}
    document, *_ = describe(GRIPPER, Options(targets=["drake"]))
    (drake,) = document["targets"]
    assert (drake["verdict"], drake["error"], drake["warning"]) == ("passes", 0, 0)


def test_statics_are_those_of_a_beam(tmp_path: Path) -> None:
    """2 kg at 0.5 m from a horizontal axis: m g r, of an effort of 20 N·m."""
    pytest.importorskip("pinocchio")
    robot = tmp_path / "beam.urdf"
    robot.write_text(
        '<robot name="r"><link name="a"/><link name="b"><inertial><origin xyz="0.5 0 0"/>'
        '<mass value="2"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'
        '</link><joint name="j" type="revolute"><parent link="a"/><child link="b"/>'
        '<axis xyz="0 1 0"/><limit lower="-1" upper="2" effort="20" velocity="1"/></joint></robot>'
    )
    (load,) = describe(str(robot))[0]["statics"]["joints"]
    assert load["worst"] == pytest.approx(2 * 9.81 * 0.5, rel=1e-3)
    assert load["used"] == pytest.approx(load["worst"] / 20)
    assert (load["joint"], load["unit"], load["exceeded"]) == ("j", "N·m", False)
    quick, *_ = describe(str(robot), quick=True)
    assert quick["statics"] is None
    assert "statics" not in quick["missing"]


def test_a_box_stands_and_tips_where_its_edge_is(tmp_path: Path) -> None:
    """A cube of 1 m with its mass in the middle: 0.5 m to every edge, 45 degrees of slope."""
    robot = tmp_path / "cube.urdf"
    robot.write_text(
        '<robot name="r"><link name="a"><inertial><mass value="2"/><inertia ixx="1" ixy="0" '
        'ixz="0" iyy="1" iyz="0" izz="1"/></inertial><collision><geometry><box size="1 1 1"/>'
        "</geometry></collision></link></robot>"
    )
    standing = describe(str(robot))[0]["standing"]
    assert standing["margin"] == pytest.approx(0.5)
    assert standing["angle"] == pytest.approx(0.7853981633974483)
    assert standing["tips"] is False


def test_parts_that_no_joint_binds_are_named(tmp_path: Path) -> None:
    pytest.importorskip("coal")
    ball = '<collision><geometry><sphere radius="1"/></geometry></collision>'
    robot = tmp_path / "two.urdf"
    links = "".join(f'<link name="{name}">{ball}</link>' for name in "ab")
    robot.write_text(f'<robot name="r">{links}</robot>')
    found = describe(str(robot))[0]
    assert (found["collisions"]["parts"], found["collisions"]["pairs"]) == (["a", "b"], [])
    assert found["robot"]["center"] == [0, 0, 0]  # nothing weighs anything
    page, _ = report(str(robot), "html")
    assert "Parts not connected by joints are not compared: a, b" in page


def test_collisions_are_those_that_can_happen(tmp_path: Path) -> None:
    """Two boxes of 0.2 m whose middles are 1 m apart; the second slides over the first, or not."""
    pytest.importorskip("coal")
    box = '<collision><geometry><box size="0.2 0.2 0.2"/></geometry></collision>'
    far = box.replace("<geometry>", '<origin xyz="0 9 0"/><geometry>')
    robot = tmp_path / "slide.urdf"
    for reach, verdict in ((0.5, "never"), (2.0, "sometimes")):
        robot.write_text(
            f'<robot name="r"><link name="a">{box}</link><link name="b">{far}</link>'
            f'<link name="c">{box}</link><joint name="f" type="fixed"><parent link="a"/>'
            '<child link="b"/></joint>'
            '<joint name="j" type="prismatic"><origin xyz="1 0 0"/><parent link="b"/>'
            f'<child link="c"/><axis xyz="-1 0 0"/><limit lower="0" upper="{reach}" effort="1" '
            'velocity="1"/></joint></robot>'
        )
        found = describe(str(robot))[0]["collisions"]
        assert found["links"] == ["a", "b", "c"]
        verdicts = {(one["first"], one["second"]): one["verdict"] for one in found["pairs"]}
        assert verdicts == {("a", "b"): "adjacent", ("a", "c"): verdict, ("b", "c"): "adjacent"}
        pair = found["pairs"][1]
        if verdict == "sometimes":  # while they are within 0.2 m of one another
            assert pair["frequency"] == pytest.approx(0.4 / 2.0, abs=0.04)
        else:
            assert pair["distance"] == pytest.approx(0.3, abs=1e-3)


def test_a_finding_knows_its_links_joints_and_lines(tmp_path: Path) -> None:
    robot = tmp_path / "robot.urdf"
    robot.write_text(
        '<robot name="r">\n<link name="a/b"/>\n<link name="c"/>\n<joint name="j" type="revolute">\n'
        '<parent link="a/b"/><child link="c"/>\n\t<limit lower="2" upper="1"/>\n</joint>\n'
        '<gazebo reference="a/b"><mu1>x</mu1></gazebo>\n</robot>\n'
    )
    document, *_ = describe(str(robot))
    found = {one["code"]: one for one in document["findings"]}
    limit = found["JNT003"]
    assert (limit["links"], limit["joints"], limit["family"]) == (["c"], ["j"], "joints")
    assert [line["line"] for line in limit["excerpt"]] == [5, 6, 7]
    assert limit["excerpt"][1]["before"] == "    "
    assert limit["excerpt"][1]["marked"].startswith("<limit lower")
    assert found["GAZ004"]["links"] == ["a/b"]


def test_an_excerpt_of_a_long_line_is_short() -> None:
    source = Source("r.urdf", b"x" * 100_000 + b"MARK" + b"y" * 100_000)
    (line,) = excerpt(Span(source, 100_000, 100_004))
    assert line == {
        "line": 1,
        "before": "..." + "x" * 80,
        "marked": "MARK",
        "after": "y" * 80 + "...",
    }


def test_an_excerpt_shows_what_steers_a_screen() -> None:
    source = Source("r.urdf", "a\x1b[31m\u202eb".encode())
    assert excerpt(Span(source, 0, 1))[0]["after"] == "\\x1b[31m\\u202eb"


def test_a_robot_that_cannot_be_read_has_its_findings_reported(tmp_path: Path) -> None:
    robot = tmp_path / "robot.urdf"
    robot.write_text("<robot><link")
    document, *_ = describe(str(robot))
    assert document["robot"] is None
    assert document["missing"]["links"] == "the description cannot be read"
    assert [one["code"] for one in document["findings"]] == ["XML001"]
    assert "XML001" in report(str(robot), "markdown")[0]
    with pytest.raises(UrdfkitError, match="no table 'links'"):
        report(str(robot), "csv", table="links")


def test_numbers_that_overflow_are_left_out_of_json(tmp_path: Path) -> None:
    robot = tmp_path / "robot.urdf"
    robot.write_text(
        '<robot name="r"><link name="a"><inertial><origin xyz="1e200 0 0"/><mass value="1e308"/>'
        '<inertia ixx="1e308" ixy="1e308" ixz="0" iyy="1e308" iyz="0" izz="1e308"/></inertial>'
        '</link><link name="b"><inertial><mass value="1e308"/></inertial></link></robot>'
    )
    text, _ = report(str(robot), "json")
    json.loads(text, parse_constant=pytest.fail)


def test_what_is_no_robot_is_said(tmp_path: Path) -> None:
    with pytest.raises(UnreadableFile):
        describe("none.urdf")
    launch = tmp_path / "robot.launch"
    launch.write_text("<launch/>")
    with pytest.raises(UnreadableRobot, match="is a launch file and describes no robot"):
        describe(str(launch))
    for name, text, reason in (
        ("c.yaml", "node:\n  ros__parameters: {}\n", "is a parameter file"),
        ("m.sdf", "<sdf/>", "the root element is <sdf>"),
    ):
        (tmp_path / name).write_text(text)
        with pytest.raises(UnreadableRobot, match=reason):
            describe(str(tmp_path / name))


def test_a_launch_file_stands_for_its_robot(tmp_path: Path) -> None:
    (tmp_path / "a.xacro").write_text(
        '<robot name="r" xmlns:xacro="http://ros.org/wiki/xacro"><xacro:arg name="n" default="a"/>'
        '<link name="$(arg n)"/></robot>'
    )
    command = f"$(find xacro)/xacro {tmp_path}/a.xacro n:=hand"
    launch = tmp_path / "robot.launch"
    launch.write_text(f'<launch><param name="robot_description" command="{command}"/></launch>')
    document = describe(str(launch)).document
    assert [link["name"] for link in document["links"]] == ["hand"]
    assert document["arguments"] == {"n": "hand"}


def test_json_is_the_document() -> None:
    text, document = report(MISSION, "json")
    assert json.loads(text) == document
    assert document["version"] == 1


def test_every_table_is_a_csv() -> None:
    for table, first, rows in (
        ("findings", "severity", len(check(MISSION).diagnostics)),
        ("links", "name", 10),
        ("joints", "name", 9),
        ("meshes", "link", 1),
    ):
        text, document = report(MISSION, "csv", table=table)
        header, *lines = csv.reader(io.StringIO(text))
        assert header[0] == first
        assert len(lines) == len(document[table]) == rows
        assert {len(line) for line in lines} == {len(header)}


def test_what_gravity_asks_is_a_table() -> None:
    pytest.importorskip("pinocchio")
    arm = str(ARM)
    text, document = report(arm, "csv", table="statics")
    rows = list(csv.DictReader(io.StringIO(text)))
    assert {row["joint"] for row in rows} == {"shoulder", "elbow"}
    assert document["collisions"] is not None or "collisions" in document["missing"]
    with pytest.raises(UrdfkitError, match="no table 'collisions'"):
        report(arm, "csv", table="collisions", quick=True)


def test_no_cell_is_a_formula(tmp_path: Path) -> None:
    robot = tmp_path / "robot.urdf"
    robot.write_text("<robot name=\"r\"><link name=\"=HYPERLINK('http://e','x')\"/></robot>")
    text, _ = report(str(robot), "csv", table="links")
    assert list(csv.reader(io.StringIO(text)))[1][0] == "'=HYPERLINK('http://e','x')"
    text, _ = report(GRIPPER, "csv", table="joints")
    assert [row[4] for row in csv.reader(io.StringIO(text))][2:] == ["0.0 1.0 0.0", "0.0 -1.0 0.0"]


def test_markdown_has_the_worst_first_and_fits_a_comment() -> None:
    text, _ = report(MISSION, "markdown")
    rows = [line for line in text.splitlines() if line.startswith("| 🔴 ")]
    assert len(rows) == 1
    assert "MSH001" in rows[0]
    assert len(text) < 65_536
    chinese, _ = report(MISSION, "markdown", language="zh")
    assert "### 检查结果" in chinese


@pytest.mark.parametrize(("name", "form"), [("a.HTML", "html"), ("b.md", "markdown")])
def test_the_suffix_is_the_form(name: str, form: str) -> None:
    assert form_of(name) == form
    with pytest.raises(UrdfkitError, match="the suffix is not one of"):
        form_of("a.pdf")


def test_a_robot_without_visuals_is_drawn_by_its_collisions(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    pytest.importorskip("PIL")
    from urdfkit.output.report import data_uris, scene

    monkeypatch.setattr(data_uris, "SHEET", (64, 36))
    body = '<collision><geometry><sphere radius="1"/></geometry></collision>'
    robot = read(Source("r.urdf", f'<robot name="r"><link name="a">{body}</link></robot>'.encode()))
    assert [*data_uris.images(scene.surfaces(robot), robot, ())] == ["views"]


def test_the_size_of_a_robot_lacks_the_shapes_of_few_links_only(tmp_path: Path) -> None:
    body, mesh = '<box size="1 1 1"/>', '<mesh filename="no.stl"/>'
    for shapes, size in (((body, body, mesh), [1.0, 1.0, 1.0]), ((body, mesh, mesh), None)):
        links = "".join(
            f'<link name="l{n}"><visual><geometry>{shape}</geometry></visual></link>'
            for n, shape in enumerate(shapes)
        )
        joints = "".join(
            f'<joint name="j{n}" type="fixed"><parent link="l0"/><child link="l{n}"/></joint>'
            for n in (1, 2)
        )
        file = tmp_path / "r.urdf"
        file.write_text(f'<robot name="r">{links}{joints}</robot>')
        assert describe(str(file), quick=True).document["robot"]["size"] == size
