"""Names of any script in images: in a font that has their letters, or escaped."""

import pytest
from PIL import Image, ImageFont

from tests.render.scenes import link, robot
from urdfkit.render import build, fonts, place_camera, with_layers
from urdfkit.render.labels import write


@pytest.fixture
def bare(monkeypatch: pytest.MonkeyPatch) -> None:
    """A system without fonts."""
    monkeypatch.setattr(fonts, "_FILES", ())


@pytest.mark.usefixtures("bare")
def test_what_no_font_has_is_escaped() -> None:
    assert fonts.writing("轮_1", 14)[1] == r"\u8f6e_1"
    assert fonts.unwritable(["wheel", "左轮", "轮"]) == "左轮"


def test_ascii_names_are_in_pillows_own_font_on_every_machine() -> None:
    own, text = fonts.writing("base_link~", 14)
    assert text == "base_link~"
    assert isinstance(own, ImageFont.FreeTypeFont)
    assert own.getname() == ("Aileron", "Regular")
    assert fonts.unwritable(["base_link"]) == ""


def test_letters_that_a_font_of_the_system_has_are_drawn() -> None:
    if fonts.unwritable(["激光"]):
        pytest.skip("no font with Chinese letters is installed")
    font, text = fonts.writing("激光", 14)
    assert text == "激光"
    laser, light = (bytes(font.getmask(letter)) for letter in text)
    assert len({laser, light, bytes(font.getmask("\uffff"))}) == 3


@pytest.mark.parametrize("name", ["激光雷达", "🤖", "колесо", "é", "\ud800", "a\x00b", ""])
def test_no_name_stops_an_image(name: str) -> None:
    context = robot(link("a", '<box size="1 1 1"/>'))
    scene = build(context)
    scene = with_layers(scene, context, ["names"], {})
    scene = scene._replace(labels=tuple(one._replace(text=name) for one in scene.labels))
    image = Image.new("RGBA", (160, 90))
    write(image, scene, place_camera(scene.points(), size=image.size))
    assert image.getbbox() is not None
