"""COL001 is about parts that run into each other, not about parts that slide along each other."""

from pathlib import Path

import pytest

pytest.importorskip("coal")

from tests.meshed import link, mesh, messages
from tests.naming import naming
from tests.physics.collision.robots import joint, revolute
from urdfkit.mesh.samples import box, stl

#: A groove along x, of two bars 20 mm apart.
GROOVE = stl(
    [
        *box((0, -0.03, 0), (0.1, -0.01, 0.04)),
        *box((0, 0.01, 0), (0.1, 0.03, 0.04)),
    ]
)


PALM = (
    '<collision><origin xyz="-0.1 0 0"/><geometry><box size="0.1 0.1 0.1"/></geometry></collision>'
)


def tongue(width: float) -> bytes:
    """A bar in the groove, with a head beyond its end."""
    bar = box((0.02, -width / 2, 0.01), (0.12, width / 2, 0.03))
    return stl([*bar, *box((0.12, -0.03, -0.01), (0.14, 0.03, 0.05))])


@pytest.mark.parametrize(
    ("width", "found"),
    [
        (0.020002, []),
        (0.0205, []),
        (0.024, [naming("left", "right", "zero")]),
    ],
)
def test_jaws_that_slide_in_each_other(tmp_path: Path, width: float, found: list[str]) -> None:
    """AR4's gripper: faces that lie on each other were "15 mm deep", as far as triangles reach."""
    robot = "".join(
        (
            link(PALM, name="palm"),
            link(mesh("groove.stl"), name="left"),
            link(mesh("tongue.stl"), name="right"),
            joint("palm", "left", "prismatic", more=revolute(0, 0.05, "0 1 0")),
            joint("palm", "right", "prismatic", more=revolute(0, 0.05, "0 -1 0")),
        )
    )
    files = {"groove.stl": GROOVE, "tongue.stl": tongue(width)}
    assert messages(tmp_path, "COL001", robot, files) == found
