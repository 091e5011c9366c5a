from __future__ import annotations

from pathlib import Path

from tests.mesh.made import glb
from tests.meshed import link, mesh, messages
from urdfkit.mesh.samples import collada, gltf

TAIL = (
    ", where y points upwards: RViz from 15.1.4 on and Drake turn it by 90 degrees, "
    "Gazebo and earlier RViz do not"
)


def test_a_robot_is_told_once(tmp_path: Path) -> None:
    robot = link(mesh("c.dae"), mesh("a.gltf"), mesh("b.glb"), mesh("a.gltf"))
    files = {"a.gltf": gltf(), "b.glb": glb(), "c.dae": collada()}
    assert messages(tmp_path, "MSH035", robot, files) == [
        f"link 'arm': the collision mesh 'a.gltf' is glTF (1 more of this robot are){TAIL}"
    ]


def test_a_broken_file_has_other_worries(tmp_path: Path) -> None:
    assert messages(tmp_path, "MSH035", link(mesh("a.glb")), {"a.glb": glb()[:-1]}) == []
