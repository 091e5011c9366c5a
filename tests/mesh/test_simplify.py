"""Fewer triangles: budgets kept, errors kept by a measure of our own, solids and materials kept."""

from functools import cache

import pytest

pytest.importorskip("numpy")
pytest.importorskip("trimesh")

import numpy as np
import trimesh

from tests.conftest import CORPUS, needs_corpus
from tests.mesh.shapes_made import as_mesh, as_part, as_trimesh
from urdfkit.mesh import simplify as module
from urdfkit.mesh.geometry import Mesh, MeshMaterial
from urdfkit.mesh.io.load import load
from urdfkit.mesh.parts import PARTS
from urdfkit.mesh.simplify import Simplified, Unreachable, to_budget, to_error

BALL = as_mesh(trimesh.creation.icosphere(3, 1.0))
OPEN = Mesh((BALL.parts[0]._replace(faces=BALL.parts[0].faces[:800]),))


@pytest.mark.usefixtures("rough_meshes")
@pytest.mark.parametrize(("mesh", "triangles"), [(BALL, 40), (OPEN, 200)], ids=["solid", "open"])
def test_a_budget_is_kept(mesh: Mesh, triangles: int) -> None:
    found = to_budget(mesh, triangles)
    assert triangles * 0.5 <= len(found.mesh.faces) <= triangles
    assert found.after.faces == len(found.mesh.faces)


def test_the_deviation_is_that_of_a_ball() -> None:
    reported: list[tuple[int, int]] = []
    found = to_budget(BALL, 300, lambda done, total: reported.append((done, total)))
    assert_steps(reported)
    assert as_trimesh(found.mesh).is_volume
    assert as_trimesh(found.mesh).volume == pytest.approx(4.18, rel=0.05)
    # All points of a ball are as far from the middle: what lies within was cut off.
    radii = np.linalg.norm(as_trimesh(found.mesh).triangles_center, axis=1)
    assert found.deviation >= 0.9 * (1 - radii.min())
    assert found.deviation < 0.1


def assert_steps(reported: list[tuple[int, int]]) -> None:
    """Progress ends where it should; every step measures, which takes a while."""
    assert reported[-1][0] == reported[-1][1]
    assert reported == sorted(reported)
    assert len(reported) <= 15


@cache
def within(error: float) -> Simplified:
    reported: list[tuple[int, int]] = []
    found = to_error(BALL, error, lambda done, total: reported.append((done, total)))
    assert_steps(reported)
    return found


@pytest.mark.parametrize("error", [0.1, 0.01])
def test_an_error_is_kept(error: float) -> None:
    found = within(error)
    assert found.deviation <= error
    assert len(found.mesh.faces) < len(BALL.faces)
    points, _ = trimesh.sample.sample_surface(as_trimesh(found.mesh), 3000, seed=3)
    assert np.abs(np.linalg.norm(points, axis=1) - 1).max() < 1.2 * error + 0.003


def test_a_looser_bound_takes_fewer_triangles() -> None:
    assert len(within(0.1).mesh.faces) < len(within(0.01).mesh.faces) / 3


def test_the_search_goes_down_to_an_eighth_in_five_steps(monkeypatch: pytest.MonkeyPatch) -> None:
    wanted: list[int] = []

    def with_fewer(mesh: Mesh, triangles: int) -> Mesh:
        wanted.append(triangles)
        return mesh._replace(parts=(mesh.parts[0]._replace(faces=mesh.parts[0].faces[:triangles]),))

    for name, stub in (
        ("within_tolerances", lambda *_: ()),
        ("with_fewer", with_fewer),
        ("directed_distance", lambda *_: 0.0),
    ):
        monkeypatch.setattr(module, name, stub)
    found = to_error(BALL, 0.1)
    parts = [8 ** -(1 - 2.0**-step) for step in range(1, 6)]
    assert wanted == [len(BALL.faces) // 2, *(round(len(BALL.faces) * part) for part in parts)]
    assert len(found.mesh.faces) == wanted[-1]


@pytest.mark.usefixtures("rough_meshes")
def test_a_flat_surface_needs_two_triangles_a_side() -> None:
    box = trimesh.creation.box().subdivide().subdivide().subdivide()
    found = to_error(as_mesh(box), 1e-4)
    assert len(found.mesh.faces) == 12
    assert as_trimesh(found.mesh).volume == pytest.approx(1)


@needs_corpus
def test_a_plate_with_holes_as_cad_programs_cut_it_into_slivers() -> None:
    mesh = load(CORPUS / "jackal/jackal_description/meshes/bridge-plate.stl")
    found = to_budget(mesh, 1900)
    assert found.after.is_solid
    assert found.deviation < 2e-4 * found.diagonal
    found = to_error(mesh, 1e-3 * found.diagonal)
    assert found.after.is_solid
    assert found.deviation <= 1e-3 * found.diagonal
    assert found.after.faces < 900


@pytest.mark.usefixtures("rough_meshes")
def test_materials_stay() -> None:
    part = next(part for part in PARTS if part.key == "hokuyo_urg04lx")
    mesh = part.build()
    found = to_budget(mesh, 500)
    assert {one.material for one in found.mesh.parts} == {one.material for one in mesh.parts}
    halves = trimesh.creation.icosphere(3, 1.0)
    upper = halves.triangles_center[:, 2] > 0
    colored = Mesh(
        tuple(
            as_part(halves, MeshMaterial(name))._replace(faces=np.array(halves.faces[which]))
            for name, which in (("up", upper), ("down", ~upper))
        )
    )
    found = to_budget(colored, 500)
    assert {one.material.name for one in found.mesh.parts if one.material} == {"up", "down"}
    for one in found.mesh.parts:
        assert one.material is not None
        heights = one.vertices[np.unique(one.faces)][:, 2] * (
            1 if one.material.name == "up" else -1
        )
        assert heights.min() > -0.1, "no colour runs over"


def test_what_is_small_enough_is_left_and_what_is_too_small_is_said() -> None:
    assert to_budget(BALL, 10**6).mesh is BALL
    two = Mesh(tuple(as_part(trimesh.creation.box()) for _ in range(3)))
    with pytest.raises(Unreachable, match="4 triangles are too few"):
        to_budget(two, 4)
