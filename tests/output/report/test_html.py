"""The HTML as text: it is whole, loads nothing, and holds nothing of a robot as markup."""

import base64
import hashlib
import json
import re
from html import unescape
from html.parser import HTMLParser
from pathlib import Path

import pytest

from tests.conftest import ARM, ROOT
from tests.shipped import MISSION
from urdfkit.core.installation import install_command
from urdfkit.errors import Unavailable, UrdfkitError
from urdfkit.lint import rule_index
from urdfkit.output.comparison import KINDS
from urdfkit.output.report import engine, html, scene
from urdfkit.output.report.translations import Translator
from urdfkit.output.report.writing import report
from urdfkit.robot.stability import VERDICTS
from urdfkit.text.diagnostic import Confidence

for module in ("jinja2", "numpy", "trimesh"):
    pytest.importorskip(module)

pytestmark = pytest.mark.usefixtures("small_pictures")
TEMPLATES = Path(html.__file__).parent / "templates"
VOID = {"meta", "link", "br", "img", "input", "wbr"}


class Elements(HTMLParser):
    """The elements of a page with their attributes, and the texts of its scripts."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.found: list[tuple[str, dict[str, str | None]]] = []
        self.scripts: list[str] = []
        self.open: list[str] = []
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.found.append((tag, dict(attrs)))
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.found.append((tag, dict(attrs)))

    def handle_data(self, data: str) -> None:
        if self.open and self.open[-1] == "script" and "type" not in self.found[-1][1]:
            self.scripts.append(data)


@pytest.fixture(scope="module")
def page() -> Elements:
    return Elements(report(MISSION, quick=True)[0])


def test_every_element_is_closed(page: Elements) -> None:
    assert page.open == []


def test_nothing_is_loaded(page: Elements) -> None:
    addresses = [
        value
        for tag, attributes in page.found
        for name, value in attributes.items()
        if name in ("src", "href", "action", "data", "srcset") and value
    ]
    assert addresses
    assert {value.partition(":")[0] for value in addresses if not value.startswith("#")} == {"data"}
    style = "".join(file.read_text(encoding="utf-8") for file in TEMPLATES.glob("*.css"))
    assert "url(" not in style
    assert "@import" not in style


def test_the_policy_names_the_scripts_that_are_there(page: Elements) -> None:
    (policy,) = [
        str(attributes["content"])
        for tag, attributes in page.found
        if tag == "meta" and attributes.get("http-equiv") == "Content-Security-Policy"
    ]
    named = set(re.findall(r"'sha256-([^']+)'", policy))
    digests = (hashlib.sha256(script.encode()).digest() for script in page.scripts)
    assert {base64.b64encode(digest).decode() for digest in digests} == named
    assert len(named) == 8
    assert policy.startswith("default-src 'none'; script-src 'sha256-")
    assert "unsafe" not in policy.partition("style-src")[0]
    assert not any(name.startswith("on") for _, attributes in page.found for name in attributes)


def test_the_same_robot_gives_the_same_page() -> None:
    arm = str(ARM)
    assert report(arm)[0] == report(arm)[0]


def test_images_are_inside() -> None:
    text, _ = report(MISSION)
    assert len(re.findall(r'<img class="picture" src="data:image/webp;base64,', text)) == 2
    text, _ = report(MISSION, quick=True)
    assert 'src="data:image/webp' not in text


def test_a_page_without_numpy_says_why(monkeypatch: pytest.MonkeyPatch) -> None:
    def missing(context: object) -> None:
        raise Unavailable(scene.without_report())

    monkeypatch.setattr(scene, "surfaces", missing)
    text, document = report(MISSION, quick=True)
    assert document["missing"] == {"3D view": scene.without_report()}
    assert "THREE" not in text
    assert install_command("report") in unescape(text)


@pytest.mark.parametrize("size", ["1e308", "1e-308", "-1", "0"])
def test_absurd_sizes_give_a_page(size: str, tmp_path: Path) -> None:
    robot = tmp_path / "robot.urdf"
    shapes = "".join(
        f"<visual><geometry>{shape}</geometry></visual>"
        for shape in (
            f'<cylinder radius="{size}" length="{size}"/>',
            f'<box size="{size} 1 {size}"/>',
            f'<sphere radius="{size}"/>',
        )
    )
    robot.write_text(
        f'<robot name="r"><link name="a">{shapes}</link><link name="b">{shapes}</link>'
        f'<joint name="j" type="prismatic"><origin xyz="{size} 0 0"/><parent link="a"/>'
        f'<child link="b"/><limit lower="-{size}" upper="{size}"/></joint></robot>'
    )
    text, document = report(str(robot), quick=True)
    assert document["robot"]["links"] == 2
    assert "<canvas" not in text
    assert 'id="robot"' in text


@pytest.mark.parametrize(
    ("limit", "reason"),
    [("MAX_LINKS", "links are more than a page"), ("MAX_TRIANGLES", "simplified: the robot has")],
)
def test_a_robot_may_be_too_large_for_a_page(
    limit: str, reason: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(scene, limit, 5)
    text, document = report(MISSION, quick=True)
    assert reason in document["missing"]["3D view"]
    assert reason in text
    assert ('id="model"' in text) == (limit == "MAX_TRIANGLES")


@pytest.mark.parametrize("content", ["", '<robot name="r"><link', '<robot name="r"/>'])
def test_a_robot_of_which_little_is_known_has_a_short_page(content: str, tmp_path: Path) -> None:
    path = tmp_path / "r.urdf"
    path.write_text(content)
    text = report(str(path))[0]
    assert '<section id="findings">' in text
    assert 'id="model"' not in text  # and no engine, which is most of a page
    assert len(text) < 60_000
    assert text.count("the description cannot be read") <= 2


def test_reasons_that_differ_in_names_only_are_one(tmp_path: Path) -> None:
    """Links that are fixed to the base by joints that have the names of the links."""
    mass = '<inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>'
    parts = "".join(
        f'<link name="{name}"/><joint name="{name}" type="fixed"><parent link="base"/>'
        f'<child link="{name}"/></joint>'
        for name in ("left", "right", "rear")
    )
    robot = tmp_path / "r.urdf"
    robot.write_text(f'<robot name="r"><link name="base">{mass}</inertial></link>{parts}</robot>')
    text, document = report(str(robot), quick=True)
    assert len(document["gazebo"]["rejected"]) == 3
    shown = unescape(text)
    assert shown.count("rejects this robot") == 1
    assert "the frame of the merged 'left' has the name" in shown
    assert "2 more like this: right, rear" in shown
    assert "()" not in shown.partition('id="gazebo"')[2].partition("</section>")[0]


def test_counts_are_singular_for_one_only() -> None:
    text, document = report(MISSION, quick=True)
    count = document["summary"]
    assert count["error"] == 1
    assert "<b>1</b>error<" in text
    assert f"<b>{count['warning']}</b>warnings<" in text
    assert f"warnings ({count['warning']})" in text


def test_a_page_without_jinja_cannot_be(monkeypatch: pytest.MonkeyPatch) -> None:
    html._environment.cache_clear()
    monkeypatch.setitem(__import__("sys").modules, "jinja2", None)
    with pytest.raises(UrdfkitError, match=re.escape(install_command("report"))):
        report(MISSION, quick=True)


def test_the_engine_carries_its_licence() -> None:
    found = engine.load()
    assert found.package.startswith("trimesh ")
    assert "Three.js Authors" in found.script[:200]
    assert "Permission is hereby granted, free of charge" in found.licence
    assert "Three.js Authors" in found.licence
    assert "$B64GLTF" not in found.script


def test_the_playground_has_the_engine_of_the_page() -> None:
    """Its 3D view consists of the same scripts."""
    package = json.loads((ROOT / "docs" / "playground" / "package.json").read_text("utf-8"))
    revision = re.findall(r'const e="(\d+)"', engine.load().script[:1000])
    assert package["dependencies"]["three"].split(".")[1] == revision[0]


def test_an_unknown_engine_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(engine, "_page", lambda archive: "<script>another</script>")
    with pytest.raises(UrdfkitError, match="is not supported"):
        engine.load()


def words_of_pages() -> set[str]:
    """Every word that the templates and scripts translate, and those that rows bring along."""
    found: set[str] = set()
    for file in TEMPLATES.iterdir():
        text = file.read_text(encoding="utf-8")
        found |= set(re.findall(r'\b(?:_|page\.word)\("([^"]+)"\)', text))
    markdown = (TEMPLATES.parent / "markdown.py").read_text(encoding="utf-8")
    found |= set(re.findall(r'\b_\("([^"]+)"\)', markdown))
    view = (TEMPLATES / "scene.html.j2").read_text(encoding="utf-8")
    found |= {pair[1] for pair in re.findall(r'\("(\w+)", "([^"]+)"', view)}
    joints = (TEMPLATES / "joints.js").read_text(encoding="utf-8")
    found |= set(re.findall(r"(?m)^    ([A-Z]\w+): \(joint\)", joints))
    found |= set(re.findall(r'button\("(\w+)"', joints))
    found |= set(rule_index.FAMILIES.values())
    found |= {*KINDS, "link", "joint", "New findings", "Fixed findings"}
    found |= {
        "passes",
        "passes with warnings",
        "fails",
        "kept",
        "merged",
        "dropped",
        "not converted",
    }
    found |= {"adjacent", "default", "always", "sometimes"}
    found |= {"macro", "include", "launch", "visual", "collision", "inferred", "guessed"}
    return found


def test_every_word_has_a_chinese_one() -> None:
    wanted = words_of_pages()
    assert len(wanted) > 90
    assert wanted - Translator("zh").known.keys() == set()


def test_what_is_translated_is_somewhere_used() -> None:
    package = ROOT / "urdfkit"
    sources = [*(package / "output").rglob("*.py"), *(package / "viewer").glob("*.py")]
    sources += [package / "robot" / "stability.py"]
    text = "".join(file.read_text(encoding="utf-8") for file in sources) + " ".join(KINDS)
    text += "".join(file.read_text(encoding="utf-8") for file in TEMPLATES.iterdir())
    text += " ".join((*Confidence, *VERDICTS.values()))
    known = Translator("zh").known.keys() - set(rule_index.FAMILIES.values())
    assert {word for word in known if word not in text} == set()


def test_the_data_of_a_page_is_json(page: Elements) -> None:
    text = report(MISSION, quick=True)[0]
    (robot,) = re.findall(r'id="robot">(.*?)</script>', text)
    assert "<" not in robot
    assert [link["name"] for link in json.loads(robot)["links"]][:2] == ["dummy", "base_footprint"]


def test_limits_have_units_and_a_short_axis_is_one_line(tmp_path: Path) -> None:
    file = tmp_path / "r.urdf"
    joints = "".join(
        f'<link name="l{n}"/><joint name="j{n}" type="continuous"><parent link="a"/>'
        f'<child link="l{n}"/><axis xyz="{axis}"/></joint>'
        for n, axis in enumerate(("0 0 1", "0.26726124 0.53452248 0.80178373"))
    )
    file.write_text(f'<robot name="r"><link name="a"/>{joints}</robot>')
    text, _ = report(str(file), "html", quick=True)
    assert "<caption>Limits in rad, N·m and rad/s; of prismatic joints in m, N and m/s" in text
    assert text.count('<td class="n short"><span') == 1
