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

from tests.meshed import SOUND
from tests.output.report.browsers import browser, needs_browser
from urdfkit.cli import main

PAYLOADS = {
    "script": "<script>pwned=1</script>",
    "image": "<img src=x onerror=pwned=1>",
    "end of script": "</script><script>pwned=1</script>",
    "end of CDATA": "]]><script>pwned=1</script>",
    "end of attribute": "\"/><script>pwned=1</script>'",
    "style": "</style></title></textarea><svg onload=pwned=1>",
    "template": "{{pwned}}{%pwned%}__proto__",
    "CSI": "\x1b[2J\x1b[31mpwned",
    "OSC 8": "\x1b]8;;http://pwned\x1b\\here\x1b]8;;\x1b\\",
    "OSC 52": "\x1b]52;c;cHduZWQ=\x07",
    "title": "\x1b]0;pwned\x07",
    "C1": "\x9b2J\x9d0;pwned\x9c",
    "newline": "a\n::error::pwned",
    "return": "a\r::error::pwned\r\n##[error]pwned",
    "controls": "\x01\x08\x08\x7f\x0b\x0c\x85pwned",
    "separators": "a\u2028::error::pwned\u2029b",
    "right to left": "\u202egpj.\u2066exe\u200f\u061cpwned",
    "invisible": "a\u200bb\ufeffc\u00ad",
    "percent": "%0A::error::pwned%0D",
    "command": "::error file=pwned,line=1::pwned",
    "formula": '=cmd|"/c calc"!A1',
    "sum": "@SUM(1+1)*cmd",
    "minus": "-2+3+cmd",
    "backticks": "`pwned` ``` ~~~",
    "pipes": "a|b||c\\|",
    "link": "](javascript:pwned=1)[x](javascript:pwned=1)",
    "picture": "![x](http://pwned/x.png)<http://pwned>",
    "heading": "# pwned\n\n---\n- x",
    "shell": "$(touch pwned);`touch pwned`",
    "Graphviz": 'a"]; b [URL="javascript:pwned"]; //\\',
    "Mermaid": 'a"]; click n0 "javascript:pwned" %% \\',
}

#: A file may have such a name, too.
FILE = (
    '<img src=x onerror=pwned=1>"`|](javascript:pwned)\n::error::a\r\x1b]52;c;cHduZWQ=\x07\u202e'
    ".urdf.xacro"
)

#: What no terminal and no log shall get, besides the end of a line.
_UNSAFE = re.compile(
    r"[^\n\S ]|[\x00-\x09\x0b-\x1f\x7f-\x9f]"
    r"|[\xad\u061c\u200b-\u200f\u2028-\u202e\u2066-\u2069\ufeff]"
)
#: What a xacro can make, and XML cannot hold.
_NOT_XML = re.compile(r"[\x00-\x08\x0b\x0c\x0e-\x1f]")
#: What GitHub and Azure take for a command in a log.
_COMMAND = re.compile(r"^\s*::|##\[|##vso", re.MULTILINE)


def named(name: str) -> str:
    """An attribute's value that is a name after the expansion, whatever XML can hold."""
    text = "".join(char if char.isalnum() else f"\\u{ord(char):04x}" for char in name)
    return f"\"${{'{text}'}}\""


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


def output(words: list[str], capsys: pytest.CaptureFixture[str]) -> str:
    """What a command prints; nothing else may be steered either."""
    code = main(words)
    out, err = capsys.readouterr()
    assert code in (0, 1), err
    assert not _UNSAFE.search(err)
    assert not _COMMAND.search(err)
    return out


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
        assert not _UNSAFE.search(text), _UNSAFE.search(text)
        assert not _COMMAND.search(text), _COMMAND.search(text)


# ------------------------------------------------------------------ for programs


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
    assert not _UNSAFE.search(text)
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
    texts = [quoteattr(one) for one in PAYLOADS.values() if not _NOT_XML.search(one)]
    includes = "".join(f"<xacro:include filename={text}/>" for text in texts)
    warned = "".join(f"<xacro:property name={text} value={text}/>" for text in texts)
    head = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
    Path(FILE).write_text(f"{head}{warned}{includes}</robot>")
    assert main([*command.split(), f"./{FILE}"]) == (2 if command != "format" else 0)
    err = capsys.readouterr().err
    assert err
    assert not _UNSAFE.search(err)
    assert not _COMMAND.search(err)


def test_a_bundle_keeps_names_in_their_places(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """In the names of its files, the URDF, the manifest and the build files."""
    pytest.importorskip("numpy")
    monkeypatch.chdir(tmp_path)
    names = [
        f"{one.replace('/', '_').replace(chr(92), '_')}.stl"
        for one in PAYLOADS.values()
        if not _NOT_XML.search(one)
    ]
    for name in names:
        Path(name).write_bytes(SOUND)
    links = "".join(
        f'<link name="l{number}"><visual><geometry><mesh filename={named(name)}/></geometry>'
        "</visual></link>"
        for number, name in enumerate(names)
    )
    head = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"'
    robot = named("../../" + "".join(names)[:100])
    Path("r.urdf.xacro").write_text(f"{head} name={robot}>{links}</robot>")
    for consumer in ("any", "ros"):
        output(["bundle", "r.urdf.xacro", "-o", consumer, "--for", consumer], capsys)
        manifest = json.loads(Path(consumer, "bundle.json").read_text())
        urdf = ElementTree.parse(Path(consumer, manifest["urdf"])).getroot()
        assert [one.tag for one in urdf.iter()] == [
            "robot",
            *("link", "visual", "geometry", "mesh") * len(names),
        ]
        meshes = {one.get("filename", "").rpartition("/")[2] for one in urdf.iter("mesh")}
        assert meshes == {path.name for path in Path(consumer, "meshes").iterdir()}
        assert meshes == set(names)
    assert re.fullmatch(r"urdf/[a-z0-9_]+\.urdf", manifest["urdf"])
    ElementTree.parse("ros/package.xml")
    assert "pwned" not in Path("ros/CMakeLists.txt").read_text().replace(
        Path(manifest["urdf"]).stem, ""
    )
    assert {path.name for path in tmp_path.iterdir()} == {*names, "r.urdf.xacro", "any", "ros"}


def test_no_name_of_a_bundle_leads_elsewhere_on_windows(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    pytest.importorskip("numpy")
    monkeypatch.chdir(tmp_path)
    obj = "mtllib a.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\n"
    mesh = '<visual><geometry><mesh filename="a.obj"/></geometry></visual>'
    Path("r.urdf").write_text(f'<robot name="r"><link name="a">{mesh}</link></robot>')
    Path("a.obj").write_text(obj)
    Path("a.mtl").write_text("newmtl a\nmap_Kd ..\\..\\a.png\n")
    Path("..\\..\\a.png").write_bytes(b"\x89PNG")
    main(["bundle", "r.urdf", "-o", "made"])
    assert not [path for path in Path("made").rglob("*") if "\\" in path.name]


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


# ------------------------------------------------------------------- for editors

#: What hovers show is Markdown; what stands in an editor is XML.
WRITTEN = [name for name in PAYLOADS if name not in ("controls", "CSI", "OSC 8", "OSC 52", "title")]


@pytest.mark.parametrize(
    "payload",
    [one for one in PAYLOADS.values() if "$(" not in one],  # which is no name, but not expanded
)
def test_a_completion_inserts_a_name_as_text(payload: str, tmp_path: Path) -> None:
    """Names of files, and of links that were expanded."""
    pytest.importorskip("pygls")
    from tests.lsp.edited import Edited
    from urdfkit.lsp import completion, features, outline
    from urdfkit.lsp.text import PositionEncoding

    mesh = f"{payload.replace('/', '_')}.stl"
    (tmp_path / mesh).touch()
    body = f"""<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
<link name={named(payload)}/>
<link name="m"><visual><geometry><mesh filename="FILE"/></geometry></visual></link>
<joint name="j" type="fixed"><parent link="LINK"/><child link="m"/></joint></robot>"""
    places = PositionEncoding("utf-16")
    for place, name in (("FILE", mesh), ("LINK", payload)):
        edited = Edited(tmp_path / "r.urdf.xacro", body.replace(place, "|"))
        markup, offset = edited.markup, edited.offset
        offers = completion.complete(edited.robot, markup, offset)
        (offer,) = [one for one in offers if one.text == name]
        item = features._item(places, markup.source, offset, offer, snippets=True)
        assert item.text_edit is not None
        assert not _UNSAFE.search(item.label)
        data, inserted = markup.source.data, item.text_edit.new_text
        text = data[: offer.start].decode() + inserted + data[offset:].decode()
        if not _NOT_XML.search(payload):
            elements = list(ElementTree.fromstring(text).iter())
            assert len(elements) == 9
            assert name in [value for one in elements for value in one.attrib.values()]
        for entry in outline.outline(edited.robot, markup):
            assert not _UNSAFE.search(features._symbol(places, entry).name)


@pytest.mark.parametrize("name", WRITTEN)
def test_a_hover_shows_names_as_they_are(name: str, tmp_path: Path) -> None:
    pytest.importorskip("pygls")
    from tests.lsp.edited import Edited
    from urdfkit.lsp.hover import hover
    from urdfkit.lsp.server import Server

    payload, image = quoteattr(PAYLOADS[name]), quoteattr(f"package://{PAYLOADS[name]}/a.png")
    text = f"""<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
<xacro:property name="p" value={payload}/>
<link name={payload}/>
<link name="${{p}}2"/>
<material name="m"><texture filename={image}/></material>
<joint name={payload} type={payload}><parent link={payload}/><child link="${{p}}2"/></joint>
</robot>"""
    (tmp_path / "r.urdf.xacro").write_text(text)
    edited = Edited(tmp_path / "r.urdf.xacro", text)
    edited.workspace.check(edited.path)
    found = edited.workspace.diagnostics(edited.path)
    published = [Server().diagnostic(one) for one in found]
    assert published
    assert not [one.message for one in published if _UNSAFE.search(one.message)]
    shown = {
        hover(edited.robot, edited.markup, offset, found)
        for offset in range(0, len(text.encode()), 3)
    }
    assert any("pwned" in one or "a" in one for one in shown)
    for one in shown:
        plain = re.sub(r"(`+)[^`\n]+\1|\\[!-/:-@\[-`{-~]", "", one)
        assert not re.search(r"\]\((?!https?://)|<|`|!\[|javascript:|pwned", plain), plain
        assert not _UNSAFE.search(one), one
