from __future__ import annotations

from pathlib import Path

import pytest

from tests.meshed import link, mesh, messages
from urdfkit.mesh.samples import collada

TAIL = ": Bullet turns it by 90 degrees, RViz, Gazebo, MoveIt and Pinocchio do not"


@pytest.mark.parametrize("axis", ["X_UP", "Y_UP"])
def test_another_axis(tmp_path: Path, axis: str) -> None:
    files = {"a.dae": collada(f"<up_axis>{axis}</up_axis>")}
    assert messages(tmp_path, "MSH014", link(mesh("a.dae")), files) == [
        f"link 'arm': the collision mesh 'a.dae' says {axis}{TAIL}"
    ]


def test_a_robot_is_told_once(tmp_path: Path) -> None:
    turned = collada("<up_axis>Y_UP</up_axis>")
    robot = link(mesh("c.dae"), mesh("a.dae"), mesh("b.dae"), mesh("a.dae"))
    files = {"a.dae": turned, "b.dae": turned, "c.dae": collada("<up_axis>Z_UP</up_axis>")}
    assert messages(tmp_path, "MSH014", robot, files) == [
        "link 'arm': the collision mesh 'a.dae' says Y_UP (1 more of this robot say such a thing)"
        + TAIL
    ]


@pytest.mark.parametrize("asset", ["", "<up_axis>Z_UP</up_axis>", "<up_axis>up</up_axis>"])
def test_nothing_to_say(tmp_path: Path, asset: str) -> None:
    assert messages(tmp_path, "MSH014", link(mesh("a.dae")), {"a.dae": collada(asset)}) == []
