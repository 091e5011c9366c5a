"""Pictures as they were when they were last looked at: alike to the eye, if not to the bit.

Other versions of numpy, and other processors, may round otherwise. Renew them after looking at
what is new: ``python -m tests.render.test_golden``.
"""

from pathlib import Path

import pytest

pytest.importorskip("PIL")
pytest.importorskip("numpy")

import numpy as np
from PIL import Image

from tests.conftest import ARM, MISSION, MOBILE_BASE
from urdfkit.lint.loading import read
from urdfkit.physics.poses import pose
from urdfkit.render import build, render_image, with_layers

DIRECTORY = Path(__file__).parent / "golden"
SIZE = (320, 200)

PICTURES = {
    "mission": (MISSION, {}, ("visual",), (), ["iso"]),
    "mission_collision": (MISSION, {}, ("visual", "collision"), (), ["iso"]),
    "arm_layers": (ARM, {"elbow": "40deg"}, ("visual",), ("frames", "joints", "inertia"), ["iso"]),
    "base_sheet": (MOBILE_BASE, {}, ("visual",), (), ["iso", "front", "left", "top"]),
}


def drawn(name: str) -> Image.Image:
    file, joints, roles, layers, views = PICTURES[name]
    robot = read(file)
    positions = pose(robot, joints)
    scene = with_layers(build(robot, positions, roles), robot, layers, positions)
    return render_image(scene, views, size=SIZE).convert("RGB")


def apart(one: Image.Image, other: Image.Image) -> tuple[float, float]:
    """The mean difference of two images, and the largest of what the eye takes in at once.

    Both in steps of 255; the second after a blur, so that a pixel at an edge counts for little.
    """
    left, right = (np.asarray(image.convert("RGB"), dtype=float) for image in (one, other))
    distance = np.abs(left - right)
    high, wide = (length // 4 * 4 for length in distance.shape[:2])
    blocks = distance[:high, :wide].reshape(high // 4, 4, wide // 4, 4, 3)
    return float(distance.mean()), float(blocks.mean(axis=(1, 3)).max())


@pytest.mark.parametrize("name", PICTURES)
def test_images_look_as_they_did(name: str) -> None:
    with Image.open(DIRECTORY / f"{name}.png") as golden:
        mean, largest = apart(drawn(name), golden)
    assert mean < 0.3
    assert largest < 12


def test_the_comparison_sees_what_an_eye_would() -> None:
    with Image.open(DIRECTORY / "mission.png") as golden:
        moved = Image.new("RGB", golden.size)
        moved.paste(golden, (1, 0))
        assert apart(golden, moved)[1] > 12
        grey = golden.convert("L")
        assert apart(golden, grey)[0] > 0.3


if __name__ == "__main__":
    DIRECTORY.mkdir(exist_ok=True)
    for each in PICTURES:
        drawn(each).save(DIRECTORY / f"{each}.png", optimize=True)
