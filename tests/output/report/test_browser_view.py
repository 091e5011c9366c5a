"""The 3D view of a report in a real browser: what is drawn, where and in which colour."""

import random
from io import BytesIO
from itertools import combinations
from math import asin, atan, radians, sin, tan
from pathlib import Path

import pytest

from tests.conftest import ARM, CORPUS, GRIPPER, MISSION, needs_corpus
from tests.output.report.browsers import Page, needs_browser, written
from urdfkit.core.spatial import Transform
from urdfkit.lint.loading import read
from urdfkit.robot.kinematics import frames

pytestmark = needs_browser
for module in ("jinja2", "numpy", "selenium", "trimesh"):
    pytest.importorskip(module)


def matrix(frame: Transform) -> list[float]:
    """As three.js has it: sixteen numbers, column by column."""
    columns = [[row[i] for row in frame.rotation] + [0.0] for i in range(3)]
    return [*columns[0], *columns[1], *columns[2], *frame.position, 1.0]


ROBOTS = [
    pytest.param(MISSION, id="mission"),
    pytest.param(GRIPPER, id="gripper"),
    pytest.param(ARM, id="arm"),
    pytest.param(
        CORPUS / "moveit_resources" / "panda_description" / "urdf" / "panda.urdf",
        id="panda",
        marks=needs_corpus,
    ),
    pytest.param(
        CORPUS / "nao_robot" / "nao_description" / "urdf" / "naoV33_generated_urdf" / "nao.urdf",
        id="nao",
        marks=needs_corpus,
    ),
]


@pytest.mark.parametrize("robot", ROBOTS)
def test_joints_move_the_links_as_our_kinematics_does(
    page: Page, robot: Path, tmp_path: Path
) -> None:
    page.open(written(robot, tmp_path))
    context = read(str(robot))
    random_ = random.Random(str(robot.name))
    given = {
        joint.name: random_.uniform(-2, 2)
        for joint in context.model.joints
        if joint.is_single_dof and not joint.mimic
    }
    assert given
    for name, position in given.items():
        page.run("urdfkit.move(arguments[0], arguments[1])", name, position)
    expected = frames(context.tree, given)
    script = "return arguments[0].map((name) => urdfkit.frame(name))"
    found = dict(zip(expected, page.run(script, list(expected)), strict=True))
    for name, frame in expected.items():
        assert found[name] == pytest.approx(matrix(frame), abs=1e-9), name
    assert page.errors == []


def test_a_slider_is_moved_by_the_keyboard(page: Page, tmp_path: Path) -> None:
    from selenium.webdriver.common.keys import Keys

    page.open(written(GRIPPER, tmp_path))
    slide = page.find(".sliders input[type=range]")
    limits = [float(slide.get_attribute(key)) for key in ("min", "max")]
    joint = next(j for j in read(str(GRIPPER)).model.joints if j.degrees_of_freedom)
    assert joint.limit
    assert joint.limit.lower
    assert joint.limit.upper
    assert limits == [joint.limit.lower.value, joint.limit.upper.value]
    slide.send_keys(Keys.END)
    expected = frames(read(str(GRIPPER)).tree, {joint.name: limits[1]})
    for name, frame in expected.items():  # the other finger follows
        assert page.run("return urdfkit.frame(arguments[0])", name) == pytest.approx(
            matrix(frame), abs=1e-9
        )
    field = page.find(".sliders input[type=number]")
    assert float(field.get_attribute("value")) == pytest.approx(limits[1], abs=1e-5)


def count_hits(page: Page, count: int, place: str) -> int:
    """How many of so many places on a line across the view, t from 0 to 1, show a link."""
    script = f"""let found = 0;
      for (let i = 0; i < arguments[0]; i++) {{
        const t = (i + 0.5) / arguments[0];
        found += urdfkit.hit({place}) === "a";
      }}
      return found"""
    hits: int = page.run(script, count)
    return hits


@pytest.mark.parametrize(
    ("shape", "half", "near", "seen"),
    [
        ('<box size="0.4 0.6 0.8"/>', (0.4**2 + 0.6**2 + 0.8**2) ** 0.5 / 2, 0.2, (0.3, 0.4)),
        ('<sphere radius="0.5"/>', 0.75**0.5, 0.0, None),
    ],
    ids=["box", "sphere"],
)
def test_a_shape_is_seen_where_perspective_puts_it(
    page: Page, tmp_path: Path, shape: str, half: float, near: float, seen: tuple[float, float]
) -> None:
    """From the front, the camera sees the face of a box that is turned to it; a ball is a disc.

    The camera is so far that a ball of radius ``half``, around the corners of the box around the
    shape, just fits the narrower angle of the view.
    """
    robot = tmp_path / "shape.urdf"
    visual = f"<visual><geometry>{shape}</geometry></visual>"
    robot.write_text(f'<robot name="r"><link name="a">{visual}</link></robot>')
    page.open(written(robot, tmp_path))
    page.find("[data-view=front]").click()
    page.wait("new Promise(requestAnimationFrame)")
    width, height = page.run(
        "return [arguments[0].clientWidth, arguments[0].clientHeight]", page.find("#stage")
    )
    across = 2 * atan(tan(radians(40) / 2) * width / height)
    distance = half / sin(min(radians(40), across) / 2)
    slopes = [tan(asin(0.5 / distance))] * 2
    if seen:
        slopes = [extent / (distance - near) for extent in seen]
    pixels = [slope / tan(radians(20)) * height for slope in slopes]
    assert count_hits(page, width, "t, 0.5") == pytest.approx(pixels[0], abs=2)
    assert count_hits(page, height, "0.5, t") == pytest.approx(pixels[1], abs=2)


def test_what_is_black_shows_its_shape(page: Page, tmp_path: Path) -> None:
    """A black sphere is shaded: its brightest part is not as dark as its darkest one."""
    image = pytest.importorskip("PIL.Image")
    ball = '<geometry><sphere radius="0.5"/></geometry>'
    black = '<material name="black"><color rgba="0 0 0 1"/></material>'
    robot = tmp_path / "ball.urdf"
    robot.write_text(
        f'<robot name="r"><link name="ball"><visual>{ball}{black}</visual></link></robot>',
        encoding="utf-8",
    )
    page.open(written(robot, tmp_path))
    picture = image.open(BytesIO(page.find("canvas").screenshot_as_png)).convert("L")
    width, height = picture.size
    box = (width // 2 - 40, height // 2 - 40, width // 2 + 40, height // 2 + 40)
    darkest, brightest = picture.crop(box).getextrema()
    assert 10 < darkest < brightest - 20 < 120


@pytest.mark.parametrize("rgba", ["0.8 0.1 0.1 1", "0 0 0 1", "1 1 1 1"])
def test_a_surface_has_the_colour_that_it_has_in_the_image(
    page: Page, tmp_path: Path, rgba: str
) -> None:
    """Both faces of a box that are seen from the front and above, away from its edges."""
    image = pytest.importorskip("PIL.Image")
    from urdfkit.render import build, render_image

    box = '<geometry><box size="0.4 0.6 0.4"/></geometry>'
    robot = tmp_path / "box.urdf"
    robot.write_text(
        f'<robot name="r"><link name="a"><visual>{box}<material name="m"><color rgba="{rgba}"/>'
        "</material></visual></link></robot>"
    )
    page.open(written(robot, tmp_path))
    drawn = render_image(build(read(str(robot))), size=(600, 600), floor=False).convert("RGB")
    shot = image.open(BytesIO(page.find("#stage canvas").screenshot_as_png)).convert("RGB")
    size = shot.size
    for up in (-0.1, 0.1):
        here = shot.getpixel((size[0] // 2, size[1] // 2 + int(up * size[0])))
        there = drawn.getpixel((300, 300 + int(up * 600)))
        assert here == pytest.approx(there, abs=20), up


def test_the_shadow_on_the_ground_has_a_soft_edge(page: Page, tmp_path: Path) -> None:
    image = pytest.importorskip("PIL.Image")
    robot = tmp_path / "table.urdf"
    shapes = "".join(
        f'<visual><origin xyz="0 0 {z}"/><geometry><box size="{size}"/></geometry></visual>'
        for z, size in ((0.5, "0.5 0.5 0.02"), (0.25, "0.02 0.02 0.5"))
    )
    robot.write_text(f'<robot name="r"><link name="a">{shapes}</link></robot>')
    page.open(written(robot, tmp_path))
    shot = image.open(BytesIO(page.find("#stage canvas").screenshot_as_png)).convert("L")
    width, height = shot.size
    ground = [shot.getpixel((x, int(0.7 * height))) for x in range(width // 2 + 10, width)]
    low, high = min(ground), max(ground)
    assert high - low > 25
    edge = [one for one in ground if low + 6 < one < high - 12]
    assert len(edge) >= 4  # pixels between shadow and light


def test_names_do_not_cover_one_another(page: Page, tmp_path: Path) -> None:
    page.open(written(MISSION, tmp_path))
    page.find("[data-layer=names]").click()
    page.wait("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
    boxes = page.run(
        "return [...document.querySelectorAll('.tag:not([hidden])')].map((tag) => {"
        " const at = tag.getBoundingClientRect(); return [at.left, at.top, at.right, at.bottom]; })"
    )
    assert len(boxes) >= 5
    for (left, top, right, bottom), (x0, y0, x1, y1) in combinations(boxes, 2):
        assert left > x1 - 1 or x0 > right - 1 or top > y1 - 1 or y0 > bottom - 1


def test_the_keyboard_turns_the_view(page: Page, tmp_path: Path) -> None:
    from selenium.webdriver.common.keys import Keys

    page.open(written(MISSION, tmp_path))
    where = "new Promise(requestAnimationFrame).then(() => urdfkit.project('wheel_1'))"
    before = page.wait(where)
    canvas = page.find("#stage canvas")
    canvas.send_keys(Keys.ARROW_LEFT)
    turned = page.wait(where)
    assert turned != pytest.approx(before, abs=1e-3)
    canvas.send_keys(Keys.ARROW_RIGHT)
    assert page.wait(where) == pytest.approx(before, abs=1e-9)
    canvas.send_keys("-")
    assert abs(page.wait(where)[0] - 0.5) < abs(before[0] - 0.5)


def colours(page: Page) -> set[tuple[int, int, int]]:
    """The colours of the 3D view, in steps of 16."""
    page.wait("new Promise((then) => requestAnimationFrame(() => requestAnimationFrame(then)))")
    image = pytest.importorskip("PIL.Image")
    with image.open(BytesIO(page.find("#stage canvas").screenshot_as_png)) as shot:
        small = shot.convert("RGB").resize((80, 80)).tobytes()
    return {(r // 16, g // 16, b // 16) for r, g, b in zip(*[iter(small)] * 3, strict=True)}


def test_findings_colour_the_links_and_all_others_step_back(page: Page, tmp_path: Path) -> None:
    page.open(written(MISSION, tmp_path))
    green = {one for one in colours(page) if one[1] > 2 * max(one[0], one[2])}
    assert green  # the link of the IMU, which has infos only
    assert not page.find("#legend").is_displayed()
    page.find("[data-layer=findings]").click()
    shown = colours(page)
    assert not green & shown
    assert any(r > 2 * max(g, b) for r, g, b in shown)  # the missing mesh
    assert any(r > 8 and 2 * b < g < r for r, g, b in shown)  # the wheels
    assert page.find("#legend").text.split() == ["error", "warning"]
    assert page.find("#scale").text == "grid 0.1 m"
