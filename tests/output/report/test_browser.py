"""The page of a report in a real browser: buttons, selection, tables, and a hostile robot."""

from math import degrees, radians
from pathlib import Path

import pytest

from tests.conftest import ARM, MISSION
from tests.output.report.browsers import Page, needs_browser, written
from urdfkit.lint.loading import read
from urdfkit.robot.joint_limits import bounds

pytestmark = needs_browser
for module in ("jinja2", "numpy", "selenium", "trimesh"):
    pytest.importorskip(module)


def test_the_buttons_above_the_sliders(page: Page, tmp_path: Path) -> None:
    page.open(written(ARM, tmp_path))
    joints = read(str(ARM)).model.joints
    limits = {joint.name: found for joint in joints if (found := bounds(joint))}

    def press(name: str) -> dict[str, float]:
        (button,) = (
            button
            for button in page.driver.find_elements("css selector", ".sliders button")
            if button.text == name
        )
        button.click()
        return dict(page.run("return {...urdfkit.positions}"))

    assert press("Lower") == pytest.approx({name: low for name, (low, _) in limits.items()})
    middle = {name: (low + high) / 2 for name, (low, high) in limits.items()}
    assert press("Middle") == pytest.approx(middle)
    first, second = press("Random"), press("Random")
    assert first != second
    assert all(low <= second[name] <= high for name, (low, high) in limits.items())
    assert press("Degrees") == second
    row = page.find(".sliders .row")
    field, unit = row.find_element("css selector", "[type=number]"), row.text.split("\n")[-1]
    name = row.find_element("css selector", "label").text
    assert unit == "°"
    assert float(field.get_attribute("value")) == pytest.approx(degrees(second[name]), abs=1e-4)
    field.clear()
    field.send_keys("30")
    assert page.run("return urdfkit.positions")[name] == pytest.approx(radians(30))


def test_a_click_selects_the_link_and_its_findings(page: Page, tmp_path: Path) -> None:
    from selenium.webdriver import ActionChains

    page.open(written(MISSION, tmp_path))
    x, y = page.run("return urdfkit.project('wheel_1')")
    canvas = page.find("#stage canvas")
    shift = ((x - 0.5) * canvas.size["width"], (y - 0.5) * canvas.size["height"])
    ActionChains(page.driver).move_to_element_with_offset(
        canvas, *map(int, shift)
    ).click().perform()
    assert page.run("return urdfkit.chosen()") == ["wheel_1"]
    assert "wheel_1" in page.find("#picked").text
    shown = page.driver.find_elements("css selector", ".finding:not([hidden])")
    assert shown
    assert all("wheel_1" in finding.get_attribute("data-links") for finding in shown)
    page.find("#all-links").click()
    assert page.run("return document.querySelectorAll('.finding[hidden]').length") == 0


def test_a_click_on_a_finding_selects_its_links(page: Page, tmp_path: Path) -> None:
    page.open(written(MISSION, tmp_path))
    finding = page.find(".finding.error")
    assert finding.get_attribute("data-links") == '["laser_frame"]'
    finding.find_element("css selector", ".message").click()
    assert page.run("return urdfkit.chosen()") == ["laser_frame"]
    assert "chosen" in finding.get_attribute("class")


def test_no_word_of_a_table_is_broken_into_letters(page: Page, tmp_path: Path) -> None:
    page.resize(390, 844)
    try:
        page.open(written(MISSION, tmp_path))
        broken = page.run(
            """const found = [];
            for (const cell of document.querySelectorAll("td, th")) {
              const walker = document.createTreeWalker(cell, NodeFilter.SHOW_TEXT);
              while (walker.nextNode()) {
                for (const { 0: word, index } of walker.currentNode.data.matchAll(/[^\\s_/,]+/g)) {
                  const range = document.createRange();
                  range.setStart(walker.currentNode, index);
                  range.setEnd(walker.currentNode, index + word.length);
                  if (range.getClientRects().length > 1) found.push(word);
                }
              }
            }
            return found"""
        )
        assert broken == []
    finally:
        page.resize(1280, 900)


def test_a_joint_may_have_any_name(page: Page, tmp_path: Path) -> None:
    robot = tmp_path / "names.urdf"
    robot.write_text(
        '<robot name="r"><link name="a"/><link name="b"/><joint name="__proto__" type="prismatic">'
        '<parent link="a"/><child link="b"/><limit lower="0" upper="1" effort="1" velocity="1"/>'
        "</joint></robot>"
    )
    page.open(written(robot, tmp_path))
    page.run("urdfkit.move('__proto__', 0.25)")
    assert page.run("return urdfkit.frame('b')[12]") == 0.25


EVIL = (
    "&lt;/script>&lt;script>window.hacked = 1&lt;/script>&lt;img src=x onerror='window.hacked=1'>"
)


def test_a_hostile_robot_is_only_text(page: Page, tmp_path: Path) -> None:
    robot = tmp_path / "evil.urdf"
    robot.write_text(
        f'<robot name="{EVIL}"><link name="{EVIL}"><inertial><mass value="-1"/>'
        '<inertia ixx="1e308" ixy="1e308" ixz="1e308" iyy="1e308" iyz="1e308" izz="1e308"/>'
        f'</inertial></link><link name="__proto__"/><joint name="{EVIL}" type="revolute">'
        f'<parent link="{EVIL}"/><child link="__proto__"/><limit lower="2" upper="1"/></joint>'
        f'<joint name="constructor" type="{EVIL}"><parent link="x"/><child link="y"/></joint>'
        "</robot>"
    )
    page.open(written(robot, tmp_path))
    name = EVIL.replace("&lt;", "<")
    assert page.run("return window.hacked") is None
    assert page.find("h1").text == name
    page.run("for (const one of document.querySelectorAll('details')) one.open = true")
    page.find("button[data-link]").click()
    assert page.run("return urdfkit.chosen()") == [name]
    assert page.find(".sliders label").text == name
    assert page.run("return document.images.length") == 1  # the tree
    assert page.errors == []


def test_the_page_in_chinese_and_in_the_dark(page: Page, tmp_path: Path) -> None:
    page.open(written(MISSION, tmp_path, language="zh"))
    assert page.run("return document.documentElement.lang") == "zh"
    assert "检查结果" in page.find("nav").text
    assert page.find(".sliders .buttons").text.startswith("零位")
    before = page.run("return getComputedStyle(document.body).backgroundColor")
    drawing = "return getComputedStyle(document.querySelector('.drawing')).filter !== 'none'"
    assert page.run(drawing) is page.run("return document.documentElement.dataset.theme === 'dark'")
    page.find("#theme").click()
    assert page.run(drawing) is page.run("return document.documentElement.dataset.theme === 'dark'")
    assert page.run("return getComputedStyle(document.body).backgroundColor") != before
    assert page.find("#theme").get_attribute("aria-pressed") in ("true", "false")


@pytest.mark.parametrize("width", [400, 800, 1400])
def test_nothing_sticks_out_of_the_page(page: Page, tmp_path: Path, width: int) -> None:
    page.resize(width, 900)
    try:
        page.open(written(MISSION, tmp_path))
        wide = "return document.documentElement.scrollWidth"
        assert page.run(wide) <= width
    finally:
        page.resize(1280, 900)


def test_the_filters(page: Page, tmp_path: Path) -> None:
    page.open(written(MISSION, tmp_path))
    shown = "return document.querySelectorAll('.finding:not([hidden])').length"
    every = page.run(shown)
    page.find(".filter input[value=info]").click()
    assert 0 < page.run(shown) < every
    page.find(".filter input[type=search]").send_keys("hokuyo missing-file")
    assert page.run(shown) == 1


def test_a_click_on_a_link_leads_to_its_findings(page: Page, tmp_path: Path) -> None:
    page.resize(1280, 900)
    page.open(written(MISSION, tmp_path))
    assert page.run("return window.scrollY") == 0
    page.run("urdfkit.showLink('wheel_1')")
    top = "document.getElementById('findings').getBoundingClientRect().top"
    page.wait(f"new Promise((then) => setInterval(() => {top} < 100 && then(), 50))")
    links = "map((one) => one.dataset.links)"
    shown = page.run(f"return [...document.querySelectorAll('.finding:not([hidden])')].{links}")
    assert shown
    assert all("wheel_1" in names for names in shown)


def test_the_width_of_the_view_is_the_readers_and_no_table_is_cut(
    page: Page, tmp_path: Path
) -> None:
    from selenium.webdriver.common.keys import Keys

    page.resize(1280, 900)
    page.open(written(MISSION, tmp_path))
    cut = "filter((one) => one.querySelector('table') && one.scrollWidth > one.clientWidth)"
    assert page.run(f"return [...document.querySelectorAll('.wide')].{cut}.length") == 0
    width = "return document.getElementById('view').offsetWidth"
    before = page.run(width)
    page.find("#divider").send_keys(Keys.ARROW_RIGHT)
    assert before < page.run(width) < before + 40
