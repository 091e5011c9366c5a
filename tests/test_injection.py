"""Names that try to leave the place where they are shown: sinks x payloads.

A new output belongs into SINKS or, if it is for a terminal or a log, into TEXTS. Pages are opened
in a real browser as well.
"""

import csv
import io
import json
import re
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path
from xml.etree import ElementTree
from xml.sax.saxutils import quoteattr

import pytest

from tests.output.report.browsers import browser, needs_browser
from tests.payloads import COMMAND, NOT_XML, PAYLOADS, UNSAFE, named, output
from urdfkit.cli import main

#: A file may have such a name, too.
FILE = (
    '<img src=x onerror=pwned=1>"`|](javascript:pwned)\n::error::a\r\x1b]52;c;cHduZWQ=\x07\u202e'
    ".urdf.xacro"
)


def part(number: int, name: str) -> str:
    """Two links with the payload in all names, and something wrong about each.

    They overlap those of the next number alone: all in one place are thousands of pairs.
    """
    return f"""<material name={named(name + "m")}/>
<link name={named(name + "a")}>
  <inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="5" ixy="0" ixz="0" iyz="0"/></inertial>
  <visual name={named(name + "v")}><geometry><mesh filename={named(name + ".stl")}/></geometry>
    <material name={named(name + "n")}/></visual>
  <collision><geometry><box size="1 1 1"/></geometry></collision>
</link>
<link name={named(name + "b")}>
  <inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>
  <visual><geometry><box size="1 1 1"/></geometry></visual>
  <collision><geometry><box size="1 1 1"/></geometry></collision>
</link>
<joint name={named(name + "i")} type="fixed"><parent link="root"/><child link={named(name + "a")}/>
  <origin xyz="{0.7 * number:g} 0 0"/></joint>
<joint name={named(name + "j")} type="revolute"><parent link={named(name + "a")}/>
  <child link={named(name + "b")}/><axis xyz="1 0 0"/>
  <limit lower="1" upper="-1" effort="1" velocity="1"/><mimic joint={named(name + "k")}/></joint>
<gazebo reference={named(name + "gone")}><sensor type="camera" name={named(name + "s")}/></gazebo>
<gazebo><plugin name={named(name + "p")} filename={named(name + ".so")}/></gazebo>
"""


@pytest.fixture
def file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, small_pictures: None) -> str:
    """A xacro with all payloads, in a file that has such a name."""
    (tmp_path / "LICENSE").touch()
    head = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"'
    parts = "".join(part(*one) for one in enumerate(PAYLOADS.values()))
    name = named(" ".join(PAYLOADS.values()))
    (tmp_path / FILE).write_text(f'{head} name={name}>\n<link name="root"/>\n{parts}</robot>\n')
    monkeypatch.chdir(tmp_path)
    return f"./{FILE}"


#: Command lines whose output is read by people, or by the log of a CI server.
TEXTS = [
    "check {}",
    "check {} --color never --statistics",
    "check {} --show-files",
    "check missing{}",
    "info {}",
    "tree {}",
    "mass {}",
    "kinematics {}",
    "statics {}",
    "collisions {} --samples 50",
    "gazebo {}",
    "inertia {}",
    "inertia {} --write",
    "doctor {}",
    "fix {} --check",
    "trace {} no/such",
    "diff {} {}",
    "bundle {} -o made",
    "migrate {} --to gz-harmonic",
    "scan {} -o out",
    "mesh info {}",
    "render {} -o made.png --size 32x32 --link {}",
]


@pytest.mark.parametrize("line", TEXTS)
def test_a_text_steers_neither_a_terminal_nor_a_ci_server(
    line: str, file: str, capsys: pytest.CaptureFixture[str]
) -> None:
    code = main([word.replace("{}", file) for word in line.split()])
    out, err = capsys.readouterr()
    assert code in (0, 1, 2), err
    assert len(out + err) > 20
    for text in (out, err):
        assert not UNSAFE.search(text), UNSAFE.search(text)
        assert not COMMAND.search(text), COMMAND.search(text)


def is_json(text: str) -> None:
    assert "pwned" in json.dumps(json.loads(text))


def is_xml(text: str, *, names: set[str]) -> None:
    """XML of these elements, none of which does anything."""
    root = ElementTree.fromstring(text)
    found = list(root.iter())
    assert {one.tag.rpartition("}")[2] for one in found} <= names
    attributes = {name.rpartition("}")[2] for one in found for name in one.attrib}
    assert not [name for name in attributes if name.startswith("on") or name == "href"]
    assert "pwned" in text


def is_junit(text: str) -> None:
    is_xml(text, names={"testsuites", "testsuite", "testcase", "failure", "skipped", "system-out"})


def is_checkstyle(text: str) -> None:
    is_xml(text, names={"checkstyle", "file", "error"})


def is_svg(text: str) -> None:
    is_xml(text, names={"svg", "g", "rect", "text", "path", "title", "line", "style", "tspan"})


def is_github(text: str) -> None:
    """A command in each line, and in no value more than its own name says."""
    assert "\r" not in text
    for line in text.removesuffix("\n").split("\n"):
        match = re.fullmatch(r"::(?:error|warning|notice) ([^:]*)::(.*)", line)
        assert match, line
        keys = [one.partition("=")[0] for one in match[1].split(",")]
        assert set(keys) <= {"file", "line", "endLine", "col", "endColumn", "title"}
        assert len(set(keys)) == len(keys)


def is_markdown(text: str) -> None:
    """Tables of as many columns in each row, and neither markup, links nor images in a name."""
    assert not UNSAFE.search(text)
    rows = 0
    for line in text.splitlines():
        plain = re.sub(r"\\[!-/:-@\[-`{-~]", "", line)  # what is escaped is a character
        tags = set(re.findall(r"<(/?\w*[^>]*)>?", plain))
        assert tags <= {*"code /code sub /sub br details /details summary /summary".split()}, line
        assert "](" not in plain, line
        assert plain.count("`") % 2 == 0, line
        rows = plain.count("|") if rows == 0 else rows
        assert not plain.startswith("|") or plain.count("|") == rows, line
        rows *= plain.startswith("|")


def is_csv(text: str) -> None:
    rows = list(csv.reader(io.StringIO(text, newline="")))
    assert len({len(row) for row in rows}) == 1
    for cell in (cell for row in rows for cell in row):
        is_number = re.fullmatch(r"[-+0-9.e ]*", cell)
        assert is_number or not cell.startswith(("=", "+", "-", "@", "\t", "\r")), cell


def is_dot(text: str) -> None:
    string = r'"(?:[^"\\]|\\.)*"'
    plain = re.sub(string, "S", text)
    assert re.fullmatch(
        r"digraph S \{\n  node \[shape=box\];\n(  S;\n|  S -> S \[label=S\];\n)*\}\n", plain
    ), plain


def is_mermaid(text: str) -> None:
    first, *lines = text.removesuffix("\n").split("\n")
    assert first == "flowchart TD"
    for line in lines:
        assert re.fullmatch(r'  n\d+(\["[^"]*"\]| -->\|"[^"]*"\| n\d+)', line), line
        assert not re.search(r"[<>`\\]", line.replace("-->", "")), line


SINKS: list[tuple[str, Callable[[str], None]]] = [
    ("check {} --format json", is_json),
    ("check {} --format sarif", is_json),
    ("check {} --format gitlab", is_json),
    ("check {} --format rdjson", is_json),
    ("check {} --format github", is_github),
    ("check {} --format junit", is_junit),
    ("check {} --format checkstyle", is_checkstyle),
    ("check {} --format markdown", is_markdown),
    ("report {} --quick", is_markdown),
    ("mass {} --format markdown", is_markdown),
    ("collisions {} --samples 50 --format markdown", is_markdown),
    ("diff other.urdf {} --format markdown", is_markdown),
    ("diff other.urdf {} --format json", is_json),
    ("tree {} --format json", is_json),
    ("info {} --format json", is_json),
    ("gazebo {} --format json", is_json),
    ("tree {} --format svg", is_svg),
    ("tree {} --format dot", is_dot),
    ("tree {} --format mermaid", is_mermaid),
    ("mass {} --format csv", is_csv),
    *(
        (f"report {{}} -o made.csv --table {name}", is_csv)
        for name in ("findings", "links", "joints", "meshes")
    ),
]


@pytest.mark.parametrize(("line", "is_sound"), SINKS, ids=[line for line, _ in SINKS])
def test_a_format_is_what_it_says(
    line: str, is_sound: Callable[[str], None], file: str, capsys: pytest.CaptureFixture[str]
) -> None:
    Path("other.urdf").write_text('<robot name="r"><link name="root"/></robot>')
    out = output([word.replace("{}", file) for word in line.split()], capsys)
    made = Path("made.csv")
    is_sound(made.read_bytes().decode() if made.exists() else out)


@pytest.mark.skipif(shutil.which("dot") is None, reason="Graphviz is not installed")
def test_graphviz_draws_no_link(file: str, capsys: pytest.CaptureFixture[str]) -> None:
    text = output(["tree", file, "--format", "dot"], capsys)
    svg = subprocess.run(["dot", "-Tsvg"], input=text, text=True, capture_output=True, check=True)
    assert "xlink:href" not in svg.stdout


@pytest.mark.parametrize("command", ["expand", "info", "tree", "mass", "render -o a.png", "format"])
def test_errors_and_warnings_steer_nothing(
    command: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """Those of xacro, too, which bear names of files and texts of the model."""
    pytest.importorskip("numpy")
    monkeypatch.chdir(tmp_path)
    texts = [quoteattr(one) for one in PAYLOADS.values() if not NOT_XML.search(one)]
    includes = "".join(f"<xacro:include filename={text}/>" for text in texts)
    warned = "".join(f"<xacro:property name={text} value={text}/>" for text in texts)
    head = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
    Path(FILE).write_text(f"{head}{warned}{includes}</robot>")
    assert main([*command.split(), f"./{FILE}"]) == (2 if command != "format" else 0)
    err = capsys.readouterr().err
    assert err
    assert not UNSAFE.search(err)
    assert not COMMAND.search(err)


@needs_browser
def test_a_page_runs_nothing_of_a_robot(file: str, capsys: pytest.CaptureFixture[str]) -> None:
    pytest.importorskip("selenium")
    pytest.importorskip("jinja2")
    Path("other.urdf").write_text('<robot name="r"><link name="root"/></robot>')
    Path("diff.html").write_text(output(["diff", "other.urdf", file, "--format", "html"], capsys))
    output(["report", file, "--quick", "-o", "report.html"], capsys)
    output(["tree", file, "--format", "svg"], capsys)
    output(["scan", file, "-o", "out"], capsys)
    output(["scan", "summary", "out"], capsys)
    with browser() as page:
        for name in ("report.html", "diff.html", "out/summary.html"):
            page.driver.get(Path(name).absolute().as_uri())
            assert "pwned" in page.run("return document.body.textContent")
            assert page.run("return typeof pwned") == "undefined"
            foreign = "img[src=x],[onerror],[onload],a[href*=pwned],a[href^=javascript]"
            assert page.run(f"return document.querySelectorAll('{foreign}').length") == 0
            page.run("for (const one of document.querySelectorAll('details')) one.open = true")
            page.run("for (const one of document.querySelectorAll('a[href^=\"#\"]')) one.click()")
            assert page.run("return typeof pwned") == "undefined"
