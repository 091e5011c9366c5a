"""Whatever a model holds, nothing crashes: coal is native code, and ends the process."""

import random
from pathlib import Path

import pytest

pytest.importorskip("coal")

from tests.physics.collision.robots import cube, joint, link, mesh, stl
from urdfkit import check
from urdfkit.lint.loading import read
from urdfkit.physics.collision.matrix import PairVerdict
from urdfkit.physics.collision.sampling import collisions
from urdfkit.text.source import Source

VALUES = (
    [*"0 -1 1e-12 1e-6 0.1 0.3 1 1e3 1e5 9.9e5 1e12 1e300 nan inf x 1e-300 -0".split(), ""]
)  # fmt: skip
MESHES = "flat nearly-flat repeated tiny huge line cube sliver tilted random".split()
SCALES = ["1 1 1", "0 1 1", "-1 1 1", "1e-3 1e-3 1e-3", "1e6 1e6 1e6", "1e-9 1 1"]
Triangle = list[list[float]]


def triangle(kind: str, chance: random.Random) -> Triangle:
    """Three points, as bad as the kind says."""
    points = [[chance.uniform(-1, 1) for _ in range(3)] for _ in range(3)]
    for point in points:
        if kind == "flat":
            point[2] = 0.3
        elif kind == "nearly-flat":
            point[2] *= 10.0 ** chance.randint(-16, -3)
        elif kind == "line":
            point[1:] = [0.0, 0.0]
        elif kind == "tilted":
            point[2] = 0.1 * point[0] + 0.2 * point[1] + chance.choice((0, 1e-17, 1e-9, 1e-7))
        elif kind in ("tiny", "huge"):
            power = chance.randint(3, 300) * (-1 if kind == "tiny" else 1)
            point[:] = [value * 10.0**power for value in point]
    if kind == "sliver":
        points[2] = [(a + b) / 2 + 1e-15 for a, b in zip(points[0], points[1], strict=True)]
    if chance.random() < 0.03:
        points[0][0] = chance.choice((float("nan"), float("inf")))
    return points


def shape(chance: random.Random, file: Path) -> str:
    def value() -> str:
        return chance.choice(VALUES)

    kind = chance.choice(["box", "cylinder", "sphere", "capsule", *["mesh"] * 4])
    if kind == "box":
        return f'<box size="{value()} {value()} {value()}"/>'
    if kind != "mesh":
        return f'<{kind} radius="{value()}" length="{value()}"/>'
    of = chance.choice(MESHES)
    triangles = [triangle(of, chance) for _ in range(chance.randint(1, 30))]
    path = cube(file, 0.3) if of == "cube" else stl(file, triangles * (1 + 19 * (of == "repeated")))
    return mesh(path, chance.choice(SCALES))


def model(seed: int, directory: Path) -> str:
    """A robot of some links with bodies of all sorts."""
    chance = random.Random(seed)
    parts = []
    for number in range(chance.randint(2, 5)):
        shapes = [
            f"{shape(chance, directory / f'{number}_{body}.stl')}@{chance.uniform(-0.3, 0.3)} 0 0"
            for body in range(chance.randint(1, 3))
        ]
        parts.append(link(f"l{number}", *shapes))
        if number:
            kind = chance.choice("fixed revolute continuous prismatic floating".split())
            value = chance.choice(VALUES)
            limits = f'<axis xyz="{value} 0 1"/><limit lower="{value}" upper="1"/>'
            where = chance.choice(("0.3 0 0.2", "0 0 0", f"{value} 0 0"))
            parts.append(joint(f"l{chance.randrange(number)}", f"l{number}", kind, where, limits))
    return f'<robot name="r">{"".join(parts)}</robot>'


@pytest.mark.parametrize("seed", range(100))
def test_a_check_survives(seed: int, tmp_path: Path) -> None:
    text = model(seed, tmp_path)
    report = check(Source(str(tmp_path / "r.urdf"), text.encode()), select=["COL"])
    assert report.crashed == ()
    assert report.skipped == ()


@pytest.mark.parametrize("seed", range(100, 104))
def test_sampling_survives(seed: int, tmp_path: Path) -> None:
    text = model(seed, tmp_path)
    robot = read(Source(str(tmp_path / "r.urdf"), text.encode()))
    found = collisions(robot, samples=300, jobs=1)
    assert all(pair.verdict is not PairVerdict.UNKNOWN for pair in found.pairs)
