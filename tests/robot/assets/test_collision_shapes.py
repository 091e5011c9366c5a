"""Collisions for links with visual meshes: which links, which edits, which files."""

from pathlib import Path

import pytest

pytest.importorskip("numpy")
pytest.importorskip("trimesh")

import numpy as np
import trimesh

from tests.mesh.shapes_made import as_mesh
from urdfkit.cli import main
from urdfkit.lint.loading import read
from urdfkit.mesh.writers import write
from urdfkit.robot.assets.collision_shapes import edited, propose
from urdfkit.robot.model import UnknownLink

pytestmark = pytest.mark.usefixtures("rough_meshes")
PRIMITIVE = "<collision><geometry><sphere radius='1'/></geometry></collision>"


def robot(
    directory: Path, link: str, mesh: trimesh.Trimesh | None = None, name: str = "r.urdf"
) -> Path:
    shape = mesh or trimesh.creation.box((0.3, 0.2, 0.1))
    write(as_mesh(shape), directory / "m.stl")
    file = directory / name
    root = '<robot name="r" xmlns:xacro="http://wiki.ros.org/xacro">'
    file.write_text(f"{root}\n  {link}\n</robot>\n", encoding="utf-8")
    return file


def link(more: str = "", scale: str = "1 1 1", name: str = "a") -> str:
    return f"""<link name="{name}">
    <visual>
      <origin xyz="1 0 0" rpy="0 0 1"/>
      <geometry><mesh filename="m.stl" scale="{scale}"/></geometry>
    </visual>{more}
  </link>"""


SAME = '<collision><geometry><mesh filename="m.stl"/></geometry></collision>'


@pytest.mark.parametrize(("more", "number"), [("", 1), (SAME, 1), (PRIMITIVE, 0)])
def test_links_without_a_collision_of_their_own(more: str, number: int, tmp_path: Path) -> None:
    assert len(propose(read(robot(tmp_path, link(more))))) == number
    assert len(propose(read(robot(tmp_path, link(more))), links=["a"])) == 1


def test_the_box_is_written_where_the_visual_is(tmp_path: Path) -> None:
    file = robot(tmp_path, link(SAME, "2 1 1"))
    context = read(file)
    assert edited(context, propose(context)).write() == [str(file)]
    (body,) = read(file).model.links_by_name["a"].collisions
    assert body.shape is not None
    assert body.shape.kind == "box"
    assert body.shape.size == pytest.approx((0.6, 0.2, 0.1))
    assert body.origin == context.model.links_by_name["a"].visuals[0].origin
    assert propose(read(file)) == ()
    assert sorted(path.name for path in tmp_path.iterdir()) == ["m.stl", "r.urdf"]


def test_a_ball_becomes_a_sphere(tmp_path: Path) -> None:
    file = robot(tmp_path, link(), trimesh.creation.icosphere(3, 0.2))
    edited(read(file), propose(read(file), error=0.01)).write()
    (body,) = read(file).model.links_by_name["a"].collisions
    assert body.shape is not None
    assert body.shape.kind == "sphere"
    assert body.shape.radius == pytest.approx(0.2, rel=0.02)


def test_the_file_of_a_hull_names_a_scale_that_is_the_same_all_over(tmp_path: Path) -> None:
    file = robot(tmp_path, link(scale="2 2 2"), trimesh.creation.cone(0.2, 0.5))
    (path,) = edited(read(file), propose(read(file), error=0.02)).meshes
    assert Path(path).name == "m_2_2_2_collision.stl"


def test_a_hull_becomes_a_file_beside_the_mesh(tmp_path: Path) -> None:
    cone = trimesh.creation.cone(0.2, 0.5)
    file = robot(tmp_path, link(scale="1 1 2"), cone)
    context = read(file)
    found = edited(context, propose(context, error=0.02))
    assert not (tmp_path / "m_1_1_2_collision.stl").exists()
    found.write()
    hull = trimesh.load_mesh(tmp_path / "m_1_1_2_collision.stl")
    assert hull.volume == pytest.approx(2 * cone.volume, rel=1e-4)
    (body,) = read(file).model.links_by_name["a"].collisions
    assert body.shape is not None
    assert body.shape.filename is not None
    assert body.shape.filename.value == "m_1_1_2_collision.stl"
    again = edited(read(file), propose(read(file), links=["a"], error=0.02))
    assert again.unchanged == {}, "the same mesh may be written again"
    (tmp_path / "m_1_1_2_collision.stl").write_bytes((tmp_path / "m.stl").read_bytes())
    other = edited(read(file), propose(read(file), links=["a"], error=0.02))
    assert "is another mesh" in other.unchanged["a"]
    assert other.files == ()


@pytest.mark.parametrize(
    "reference", ["file://$(dirname)/m.stl", "package://r&amp;d/m.stl", "${'m'}.stl"]
)
def test_a_hull_is_named_as_the_mesh_is(reference: str, tmp_path: Path) -> None:
    shape = trimesh.creation.icosphere(subdivisions=2).slice_plane((0, 0, 0), (0, 0, 1), cap=True)
    directory = tmp_path / "r&d"
    directory.mkdir()
    (directory / "package.xml").write_text("<package><name>r&amp;d</name></package>")
    file = robot(directory, link().replace("m.stl", reference), shape, "r.xacro")
    context = read(file, packages={"r&d": str(directory)})
    edited(context, propose(context, error=0.01)).write()
    assert f'<mesh filename="{reference.removesuffix(".stl")}_collision.stl"/>' in file.read_text()
    (body,) = read(file).model.links_by_name["a"].collisions
    assert body.shape is not None
    assert read(file, packages={"r&d": str(directory)}).files.path(body.shape)


def test_pieces_become_several_collisions(tmp_path: Path) -> None:
    parts = [trimesh.creation.box((1, 0.2, 0.2)), trimesh.creation.box((0.2, 0.2, 1))]
    parts[1].apply_translation((-0.4, 0, 0.4))
    file = robot(tmp_path, link(), trimesh.boolean.union(parts, engine="manifold"))
    edited(read(file), propose(read(file), error=0.05, most=4)).write()
    bodies = read(file).model.links_by_name["a"].collisions
    assert len(bodies) >= 2
    context = read(file)
    volume = sum(
        trimesh.Trimesh(mesh.vertices, mesh.faces).volume
        for mesh in (context.meshes.mesh(body.shape) for body in bodies if body.shape)
        if mesh
    )
    assert volume == pytest.approx(0.072, rel=0.1)


def test_what_cannot_be_written_is_said(tmp_path: Path) -> None:
    text = f'<xacro:macro name="m">{link()}</xacro:macro><xacro:m/>{link(name="b")}'
    file = robot(tmp_path, text, name="r.xacro")
    found = edited(read(file), propose(read(file)))
    assert set(found.unchanged) == {"a"}
    assert "a macro creates it" in found.unchanged["a"]
    assert len(found.files) == 1
    (tmp_path / "m.stl").write_bytes(b"")
    (first, _) = propose(read(file))
    assert "empty" in first.reason
    with pytest.raises(UnknownLink):
        propose(read(file), links=["nobody"])


def test_the_command(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = robot(tmp_path, link())
    before = file.read_bytes()
    assert main(["mesh", "collision", str(file)]) == 0
    assert "selected: box (within" in capsys.readouterr().out
    assert main(["mesh", "collision", str(file), "--diff"]) == 0
    assert '+        <box size="0.3 0.2 0.1"/>' in capsys.readouterr().out
    assert file.read_bytes() == before
    assert main(["mesh", "collision", str(file), "--write"]) == 0
    assert capsys.readouterr().out.endswith(f"\nwrote {file}\n")
    assert main(["mesh", "collision", str(file)]) == 0
    assert "has a collision of its own" in capsys.readouterr().out
    assert main(["mesh", "collision", str(file), "--error", "0"]) == 2
    flat = trimesh.Trimesh(np.eye(3), [[0, 1, 2]])
    assert main(["mesh", "collision", str(robot(tmp_path, link(), flat)), "--write"]) == 1
    assert "is unchanged: all points lie in a plane" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("kind", "axis", "origin", "taken"),
    [
        ("continuous", "0 0 1", "0 0 0.02", "cylinder"),
        ("continuous", "0 0 -2", "0 0 0", "cylinder"),
        ("continuous", "1 0 0", "0 0 0", "pieces"),
        ("continuous", "0 0 1", "0.05 0 0", "pieces"),
        ("revolute", "0 0 1", "0 0 0", "pieces"),
    ],
)
def test_a_wheel_rolls_on_a_cylinder(
    kind: str, axis: str, origin: str, taken: str, tmp_path: Path
) -> None:
    """A tyre without a hub: every solid shape around it sticks out by far."""
    write(as_mesh(trimesh.creation.annulus(0.07, 0.1, 0.04, sections=48)), tmp_path / "a.stl")
    (tmp_path / "r.urdf").write_text(
        '<robot name="r"><link name="base"/><link name="wheel"><visual>'
        f'<origin xyz="{origin}"/><geometry><mesh filename="a.stl"/></geometry></visual></link>'
        f'<joint name="j" type="{kind}"><parent link="base"/><child link="wheel"/>'
        f'<axis xyz="{axis}"/></joint></robot>'
    )
    (proposal,) = propose(read(tmp_path / "r.urdf"))
    (fits,) = proposal.fits
    assert fits.best.kind == taken
    assert bool(fits.why) == (taken == "cylinder")
    if taken == "cylinder":
        assert fits.best.size[:2] == pytest.approx((0.1, 0.04), rel=1e-3)
