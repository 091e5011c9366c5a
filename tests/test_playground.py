"""The playground in a browser: the same findings as the command line, fixes, links and zips."""

import gzip
import importlib.util
import json
import os
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator
from http.server import SimpleHTTPRequestHandler
from io import BytesIO
from pathlib import Path
from struct import pack
from typing import Any
from zlib import compress, crc32

import pytest

from docs.playground.build import EXAMPLES, build
from tests.conftest import CORPUS, MODELS, needs_corpus
from tests.output.report.browsers import Page, browser, needs_browser, served

pytestmark = needs_browser

BROKEN = """<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="mass" value="-1"/>
  <link name="a">
    <inertial>
      <mass value="${mass}"/>
      <inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/>
    </inertial>
  </link>
  <link name="b"/>
  <joint name="j" type="fixed"><parent link="a"/><child link="b"/><axis xyz="0 0 1"/></joint>
</robot>
"""


ASKED: list[str] = []  # for which paths the server was asked


class Recording(SimpleHTTPRequestHandler):
    def log_message(self, format: str, *args: Any) -> None:
        ASKED.append(self.path)


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The playground as it is built."""
    directory = tmp_path_factory.mktemp("site")
    build(directory)
    if not (directory / "playground.js").is_file():
        pytest.skip("npm is not installed, or reaches no registry")
    return directory


@pytest.fixture(scope="module")
def address(site: Path) -> Iterator[str]:
    """Where the playground is served."""
    with served(site, Recording) as top:
        yield f"{top}/"


@pytest.fixture(scope="module")
def page(address: str) -> Iterator[Page]:
    with browser() as opened:
        opened.driver.get(address)
        yield opened


def status(page: Page) -> str:
    return str(page.find("#status").text)


def wait(page: Page, holds: Callable[[], bool]) -> None:
    """Until the page has done what it was told."""
    from selenium.webdriver.support.ui import WebDriverWait

    WebDriverWait(page.driver, 120).until(lambda _: holds(), status(page))


def is_checked(page: Page) -> bool:
    return status(page).startswith("errors: ")


def findings(page: Page) -> list[str]:
    """Path, line, severity and code of each finding."""
    shown = page.driver.find_elements("css selector", "#findings li > small:first-child")
    return [str(one.text).strip() for one in shown]


def printed(directory: Path, named: str = ".") -> list[str]:
    """The same of the command line, in an environment without extras."""
    lean = directory.parent / "lean"
    if not lean.exists():
        lean.mkdir()
        for name in ("click", "urdfkit", "xacro", "yaml"):
            spec = importlib.util.find_spec(name)
            assert spec is not None
            assert spec.origin is not None
            (lean / name).symlink_to(Path(spec.origin).parent)
    done = subprocess.run(
        [sys.executable, "-S", "-m", "urdfkit", "check", named, "--format", "json", "--no-cache"],
        check=False,
        cwd=directory,
        env={**os.environ, "PYTHONPATH": str(lean)},
        capture_output=True,
        text=True,
    )
    assert done.returncode in {0, 1}, done.stderr
    order = ["error", "warning", "info"].index
    found = sorted(json.loads(done.stdout)["diagnostics"], key=lambda one: order(one["severity"]))
    return [f"{one['path']}:{one['line']} {one['severity']} {one['code']}" for one in found]


def test_the_robot_is_drawn_next_to_its_findings(page: Page, address: str) -> None:
    page.driver.get("about:blank")
    page.driver.get(address)
    wait(page, lambda: is_checked(page) and bool(page.find("#scale").text))
    assert page.find("#scale").text == "grid 0.1 m"
    assert len(page.driver.find_elements("css selector", ".sliders input[type=range]")) == 4
    page.find("#view canvas").click()  # in the middle of the view: a link with findings
    chosen = page.driver.find_elements("css selector", "#findings li.chosen")
    assert chosen
    assert all("waking_robot_new.xacro" in one.text for one in chosen)
    assert [one for one in page.errors if "favicon" not in one] == []


def test_the_page_takes_eight_megabytes_to_load(site: Path) -> None:
    """Packed as a server packs them: what a visitor who starts with the first example loads."""
    loaded = [path for path in site.rglob("*") if path.is_file() and "examples" not in path.parts]
    loaded.append(site / "examples" / "gazebo_pkg.zip")
    assert sum(len(gzip.compress(path.read_bytes(), 6)) for path in loaded) <= 8_000_000


def test_the_bar_above_is_one_row_at_1400_pixels(page: Page) -> None:
    wait(page, lambda: is_checked(page))
    page.resize(1400, 900)
    try:
        assert page.find("header").size["height"] < 45
    finally:
        page.resize(1280, 900)


@pytest.mark.parametrize("width", [390, 1280])
def test_nothing_sticks_out_of_the_page(page: Page, tmp_path: Path, width: int) -> None:
    model = tmp_path / "robot.urdf"
    long = "/".join(["a_very_long_name_of_a_directory"] * 12)
    mesh = f'<visual><geometry><mesh filename="package://p/{long}.stl"/></geometry></visual>'
    model.write_text(f'<robot name="r"><link name="a">{mesh}</link></robot>')
    page.resize(width, 844)
    try:
        drop(page, model)
        assert page.run("return document.documentElement.scrollWidth") <= width
        results = page.find("#results")
        assert page.run("return arguments[0].scrollWidth <= arguments[0].clientWidth", results)
    finally:
        page.resize(1280, 900)


@pytest.mark.parametrize(("size", "count"), [(400_000_000, 1), (1, 30_000)])
def test_a_zip_that_a_browser_cannot_hold_is_rejected(
    size: int, count: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    import zipfile

    from docs.playground import browser as served

    class Sent(bytes):
        def to_bytes(self) -> bytes:
            return bytes(self)

    monkeypatch.setattr(served, "ROOT", tmp_path / "robot")
    monkeypatch.setattr(zipfile.ZipFile, "extractall", lambda *_: pytest.fail("it was unpacked"))
    with zipfile.ZipFile(tmp_path / "bomb.zip", "w", zipfile.ZIP_DEFLATED) as file:
        for number in range(count):
            with file.open(f"{number}.stl", "w") as member:
                for _ in range(max(size // 10_000_000, 1)):
                    member.write(bytes(min(size, 10_000_000)))
    with pytest.raises(ValueError, match="the playground takes"):
        served.unpack(Sent((tmp_path / "bomb.zip").read_bytes()))


def zipped(work: Path) -> Path:
    """A zip of what is in a directory, next to it."""
    return Path(shutil.make_archive(str(work), "zip", work))


def drop(page: Page, path: Path) -> None:
    """Open a file as if it were chosen, once the robot that the page starts with is checked."""
    wait(page, lambda: is_checked(page))
    page.driver.execute_script("document.getElementById('status').textContent = ''")
    page.find("#open").send_keys(str(path))
    wait(page, lambda: is_checked(page))


@pytest.mark.parametrize("example", EXAMPLES)
def test_an_example_has_the_findings_of_the_command_line(
    page: Page, example: str, tmp_path: Path
) -> None:
    from selenium.webdriver.support.ui import Select

    wait(page, lambda: is_checked(page))
    name = example.rpartition("/")[2]
    page.driver.execute_script("document.getElementById('status').textContent = ''")
    Select(page.find("#example")).select_by_visible_text(name)
    if name == "gazebo_pkg":  # chosen from the start: nothing changes
        page.driver.execute_script(
            "document.getElementById('example').dispatchEvent(new Event('change'))"
        )
    wait(page, lambda: is_checked(page))
    package = tmp_path / "work"
    package.mkdir()
    shutil.copytree(MODELS / example, package / name)
    assert findings(page) == printed(package)
    if name == "gazebo_pkg":
        assert len(findings(page)) > 40


def test_a_zip_is_a_package(page: Page, tmp_path: Path) -> None:
    work = tmp_path / "work"
    (work / "arm").mkdir(parents=True)
    (work / "arm" / "arm.xacro").write_text(
        BROKEN.replace("<link", '<xacro:include filename="macros.xacro"/>\n  <link')
    )
    (work / "arm" / "macros.xacro").write_text("<robot><!-- é --><link name='c'/></robot>")
    drop(page, zipped(work))
    assert findings(page) == printed(work)
    assert "arm/arm.xacro:6 error INE001" in findings(page)


@needs_corpus
@pytest.mark.parametrize("name", ["anymal_c_simple_description", "linorobot2", "turtlebot3"])
def test_a_public_robot_has_the_findings_of_the_command_line(
    page: Page, name: str, tmp_path: Path
) -> None:
    work = tmp_path / "work"
    shutil.copytree(CORPUS / name, work / name)
    drop(page, zipped(work))
    assert findings(page) == printed(work)


def test_a_robot_is_typed_fixed_and_linked(page: Page, address: str, tmp_path: Path) -> None:
    model = tmp_path / "work" / "robot.xacro"
    model.parent.mkdir()
    model.write_text(BROKEN)
    drop(page, model)
    before = findings(page)
    assert before == printed(model.parent, model.name)
    assert page.driver.find_elements("css selector", ".cm-lint-marker-error")
    assert '<mass value="-1"/>' in page.find("#expanded").get_attribute("textContent")

    assert "robot.xacro:10 info JNT020" in findings(page)
    page.driver.execute_script("document.getElementById('status').textContent = ''")
    page.find("#findings button").click()
    wait(page, lambda: is_checked(page))
    assert not [one for one in findings(page) if "JNT020" in one]
    assert "<axis" not in page.find(".cm-content").text

    page.find("#link").click()
    wait(page, lambda: "#" in page.driver.current_url)
    fixed = findings(page)
    linked = page.driver.current_url
    page.driver.get("about:blank")
    page.driver.get(linked)
    wait(page, lambda: is_checked(page))
    assert findings(page) == fixed


def png(colour: bytes) -> bytes:
    """An image of one pixel."""

    def chunk(kind: bytes, data: bytes) -> bytes:
        return pack(">I", len(data)) + kind + data + pack(">I", crc32(kind + data))

    head = chunk(b"IHDR", pack(">IIBBBBB", 1, 1, 8, 2, 0, 0, 0))
    body = chunk(b"IDAT", compress(b"\0" + colour))
    return b"\x89PNG\r\n\x1a\n" + head + body + chunk(b"IEND", b"")


LAMP = """<library_lights><light id="lamp"><technique_common><point><color>9 9 9</color></point>
</technique_common></light></library_lights>"""
DAE = """<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset/>
<library_images><image id="image"><init_from>{image}</init_from></image></library_images>
<library_effects><effect id="effect"><profile_COMMON>
<newparam sid="surface"><surface type="2D"><init_from>image</init_from></surface></newparam>
<newparam sid="sampler"><sampler2D><source>surface</source></sampler2D></newparam>
<technique sid="common"><lambert><diffuse><texture texture="sampler" texcoord="UV"/></diffuse>
</lambert></technique></profile_COMMON></effect></library_effects>
<library_materials><material id="paint"><instance_effect url="#effect"/></material>
</library_materials>{lamp}
<library_geometries><geometry id="shape"><mesh>
<source id="places"><float_array id="p" count="12">0 -1 -1 0 1 -1 0 1 1 0 -1 1</float_array>
<technique_common><accessor source="#p" count="4" stride="3"><param name="X" type="float"/>
<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<source id="uv"><float_array id="t" count="8">0 0 1 0 1 1 0 1</float_array>
<technique_common><accessor source="#t" count="4" stride="2"><param name="S" type="float"/>
<param name="T" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#places"/></vertices>
<triangles material="paint" count="2"><input semantic="VERTEX" source="#v" offset="0"/>
<input semantic="TEXCOORD" source="#uv" offset="1" set="0"/><p>0 0 1 1 2 2 0 0 2 2 3 3</p>
</triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="scene"><node><instance_geometry url="#shape">
<bind_material><technique_common><instance_material symbol="paint" target="#paint">
<bind_vertex_input semantic="UV" input_semantic="TEXCOORD" input_set="0"/></instance_material>
</technique_common></bind_material></instance_geometry></node>{node}</visual_scene>
</library_visual_scenes><scene><instance_visual_scene url="#scene"/></scene></COLLADA>"""
LIT = '<node><translate>2 0 0</translate><instance_light url="#lamp"/></node>'


def opened(page: Page, work: Path, image: str, lamp: bool) -> tuple[int, ...]:
    """The colour in the middle of the view of a square in COLLADA, seen from the front."""
    (work / "meshes").mkdir(parents=True)
    (work / "package.xml").write_text("<package><name>private</name></package>")
    dae = DAE.format(image=image, lamp=LAMP * lamp, node=LIT * lamp)
    (work / "meshes" / "square.dae").write_text(dae)
    (work / "meshes" / "red.png").write_bytes(png(b"\xff\0\0"))
    mesh = '<geometry><mesh filename="package://private/meshes/square.dae"/></geometry>'
    (work / "r.urdf").write_text(
        f'<robot name="r"><link name="a"><visual>{mesh}</visual></link></robot>'
    )
    drop(page, zipped(work))
    page.find("[data-layer=findings]").click()
    page.find("[data-view=front]").click()
    wait(page, lambda: bool(page.find("#scale").text == "grid 0.5 m"))
    page.wait("new Promise((then) => setTimeout(then, 1500))")
    shot = pytest.importorskip("PIL.Image").open(
        BytesIO(page.find("#stage canvas").screenshot_as_png)
    )
    page.find("[data-layer=findings]").click()
    colour: tuple[int, ...] = shot.convert("RGB").getpixel((shot.width // 2, shot.height // 2))
    return colour


def test_names_in_a_model_reach_no_server(page: Page, tmp_path: Path) -> None:
    wait(page, lambda: is_checked(page))
    page.run("console.clear()")
    assert page.errors is not None
    before = len(ASKED)
    red = opened(page, tmp_path / "one", "red.png", lamp=False)
    assert red[0] > 150  # the texture is in the zip
    assert max(red[1:]) < 80
    white = opened(page, tmp_path / "two", "secret/project_x.png", lamp=False)
    assert min(white) > 150
    elsewhere = opened(page, tmp_path / "three", "http://127.0.0.1:1/secret.png", lamp=False)
    assert elsewhere == white
    assert ASKED[before:] == []
    assert [one for one in page.errors if "File version" not in one] == []


def test_lamps_in_a_mesh_light_nothing(page: Page, tmp_path: Path) -> None:
    colours = [opened(page, tmp_path / str(lamp), "red.png", lamp=lamp) for lamp in (False, True)]
    assert colours[0] == colours[1]


def test_a_link_has_the_texts_of_a_package(page: Page, address: str, tmp_path: Path) -> None:
    work = tmp_path / "work"
    (work / "arm").mkdir(parents=True)
    include = '<xacro:include filename="macros.xacro"/>'
    (work / "arm" / "arm.xacro").write_text(BROKEN.replace("<link", f"{include}\n  <link", 1))
    (work / "arm" / "macros.xacro").write_text("<robot><link name='c'/></robot>")
    drop(page, zipped(work))
    found = findings(page)
    page.find("#link").click()
    wait(page, lambda: "2 texts" in status(page))
    linked = page.driver.current_url
    page.driver.get("about:blank")
    page.driver.get(linked)
    wait(page, lambda: is_checked(page))
    assert findings(page) == found


def test_a_link_writes_into_the_package_alone(tmp_path: Path, monkeypatch) -> None:
    from docs.playground import browser as served

    monkeypatch.setattr(served, "ROOT", tmp_path / "robot")
    served.write("urdf/r.urdf", "<robot/>")
    assert (tmp_path / "robot" / "urdf" / "r.urdf").is_file()
    for path in ("../r.urdf", "urdf/../../r.urdf", "/etc/passwd"):
        with pytest.raises(ValueError, match="outside"):
            served.write(path, "")


def test_files_that_a_mesh_names_are_found(tmp_path: Path) -> None:
    from docs.playground import browser as served

    (tmp_path / "textures").mkdir()
    for name in ("textures/a b.png", "c.jpg", "d.bin"):
        (tmp_path / name).write_bytes(b"")
    (tmp_path / "m.mtl").write_text("newmtl x\nmap_Kd c.jpg\n")
    (tmp_path / "m.obj").write_text("mtllib m.mtl\nv 0 0 0\n")
    (tmp_path / "m.dae").write_text("<init_from>textures/a%20b.png</init_from><x>no.png</x>")
    (tmp_path / "m.gltf").write_text('{"buffers": [{"uri": "d.bin"}]}')
    (tmp_path / "m.stl").write_bytes(b"solid c.jpg\n")
    found = {
        kind: json.loads(served.named(str(tmp_path / f"m.{kind}")))
        for kind in ("obj", "dae", "gltf", "stl")
    }
    at = str(tmp_path)
    assert found["obj"] == {"m.mtl": f"{at}/m.mtl", "c.jpg": f"{at}/c.jpg"}
    assert found["dae"] == {"textures/a%20b.png": f"{at}/textures/a b.png"}
    assert found["gltf"] == {"d.bin": f"{at}/d.bin"}
    assert found["stl"] == {}
