"""The kinematic tree in every format: real programs read it, and hostile names do no harm."""

import json
import re
import shutil
import subprocess
from xml.etree import ElementTree

import pytest

from tests.conftest import GRIPPER
from tests.documents import tree
from tests.growth import executed_lines
from tests.jointed import joint, limit, mimic, robot
from urdfkit.lint.loading import load
from urdfkit.output.diagrams import FORMATS, dot, mermaid, svg, text
from urdfkit.output.diagrams import json as json_diagram
from urdfkit.output.diagrams.rows import caption, rows
from urdfkit.robot.joint import Joint
from urdfkit.robot.tree import KinematicTree

RENDER = {
    "text": text.render,
    "dot": dot.render,
    "mermaid": mermaid.render,
    "svg": svg.render,
    "json": json_diagram.render,
}
NASTY = "a&quot;b\\&lt;c&gt;`#]--|d"  # what it stands for: a"b\<c>`#]--|d

BRANCHES = robot(
    joint("left", "revolute", '<axis xyz="0 1 0"/>' + limit("-1", "2", "30", "4")),
    joint("tip", "fixed", parent="left_link"),
    joint("right", "prismatic", '<axis xyz="0 0 -1"/>' + limit("0", "0.1")),
)
LOOP = (
    '<link name="a"/><link name="b"/>'
    '<joint name="ab" type="fixed"><parent link="a"/><child link="b"/></joint>'
    '<joint name="ba" type="fixed"><parent link="b"/><child link="a"/></joint>'
)


def only_joint(content: str, kind: str = "revolute") -> Joint:
    (found,) = tree(robot(joint("j", kind, content))).model.joints
    return found


def test_every_format_has_its_module() -> None:
    assert tuple(RENDER) == FORMATS


def test_text() -> None:
    assert text.render(tree(BRANCHES)) == (
        "base\n"
        "├ left_link  left: revolute about y, -1 to 2 rad, 30 N·m, 4 rad/s\n"
        "│ └ tip_link  tip: fixed\n"
        "└ right_link  right: prismatic along -z, 0 to 0.1 m, 10 N, 1 m/s\n"
    )


def test_what_is_too_wide_goes_on_below() -> None:
    assert text.render(tree(BRANCHES), width=50) == (
        "base\n"
        "├ left_link  left: revolute about y, -1 to 2 rad,\n"
        "│ │   30 N·m, 4 rad/s\n"
        "│ └ tip_link  tip: fixed\n"
        "└ right_link  right: prismatic along -z,\n"
        "      0 to 0.1 m, 10 N, 1 m/s\n"
    )


@pytest.mark.parametrize(
    ("content", "kind", "expected"),
    [
        ("", "continuous", "continuous about x"),
        ('<axis xyz="3 0 4"/>', "continuous", "continuous about 0.6 0 0.8"),
        ('<axis xyz="0 0 1"/>', "fixed", "fixed"),
        ("", "floating", "floating"),
        ("", "planar", "planar across x"),
        ("", "wobbly", "wobbly"),
        (mimic("k"), "continuous", "continuous about x, follows k"),
        (
            mimic("k", 'multiplier="-2" offset="0.5"'),
            "continuous",
            "continuous about x, follows -2 x k +0.5",
        ),
    ],
)
def test_captions(content: str, kind: str, expected: str) -> None:
    assert caption(only_joint(content, kind)) == expected


@pytest.mark.parametrize("form", FORMATS)
def test_loops_end(form: str) -> None:
    assert RENDER[form](tree(LOOP))


def test_a_link_of_two_parents_is_drawn_twice_and_opened_once() -> None:
    second = '<joint name="j2" type="fixed"><parent link="left_link"/><child link="right_link"/>'
    found = list(rows(tree(BRANCHES + second + "</joint>")))
    assert [row.is_again for row in found if row.link == "right_link"] == [False, True]
    drawn = text.render(tree(BRANCHES + second + "</joint>"))
    assert "j2: fixed\n" in drawn
    assert drawn.endswith("(see above)\n")


@pytest.mark.parametrize("form", FORMATS)
def test_deep_and_wide_robots_take_linear_time(form: str) -> None:
    def lines(number: int) -> int:
        deep = "".join(
            joint(f"j{i}", "fixed", parent=f"j{i - 1}_link" if i else "base") for i in range(number)
        )
        wide = "".join(joint(f"w{i}", "fixed") for i in range(number))
        both = tree(robot(deep, wide))
        assert f"w{number - 1}" in RENDER[form](both)
        return executed_lines(lambda: RENDER[form](both))

    assert lines(1000) < 110 * lines(10)


def test_graphviz_reads_nasty_names() -> None:
    program = shutil.which("dot")
    if program is None:
        pytest.skip("graphviz is not installed")
    drawn = dot.render(tree(f'<link name="{NASTY}"/>'))
    subprocess.run([program, "-Tsvg"], input=drawn, text=True, check=True, capture_output=True)


def test_strings_of_dot_end_where_they_should() -> None:
    drawn = dot.render(tree(f'<link name="{NASTY}"/>'))
    (quoted,) = re.findall(r'^  ("(?:[^"\\]|\\.)*");$', drawn, re.MULTILINE)
    assert json.loads(quoted) == 'a"b\\<c>`#]--|d'


def test_mermaid_has_entities_for_what_means_something() -> None:
    drawn = mermaid.render(tree(f'<link name="{NASTY}"/>'))
    assert 'n0["a#quot;b#92;#lt;c#gt;#96;#35;]--|d"]' in drawn


def test_svg_is_xml_and_nothing_leaves_its_edges() -> None:
    drawn = ElementTree.fromstring(svg.render(tree(BRANCHES + f'<link name="{NASTY}"/>')))
    space = "{http://www.w3.org/2000/svg}"
    width, height = float(drawn.attrib["width"]), float(drawn.attrib["height"])
    boxes = [box for box in drawn.findall(f"{space}rect") if box.get("rx")]
    texts = [one.text for one in drawn.findall(f"{space}text")]
    assert len(boxes) == 5
    assert 'a"b\\<c>`#]--|d' in texts
    assert "left: revolute about y, -1 to 2 rad, 30 N·m, 4 rad/s" in texts
    for box in boxes:
        assert float(box.attrib["x"]) + float(box.attrib["width"]) <= width
        assert float(box.attrib["y"]) + float(box.attrib["height"]) <= height
    assert len({box.attrib["y"] for box in boxes}) == 5


def test_json_holds_everything_once() -> None:
    document = json.loads(json_diagram.render(KinematicTree(load(GRIPPER))))
    assert document["roots"] == ["mount"]
    assert [link["name"] for link in document["links"]] == [
        "mount", "palm", "left_finger", "right_finger",
    ]  # fmt: skip
    assert [link["depth"] for link in document["links"]] == [0, 1, 2, 2]
    right = document["joints"][-1]
    assert right["mimic"] == {"joint": "left_finger_joint", "multiplier": 1.0, "offset": 0.0}
    assert right["limits"] == [0.0, 0.05]
    assert right["axis"] == [0.0, -1.0, 0.0]
