"""What a picture costs, beside pyrender and VTK, on one machine and in the same run.

A robot-like scene of 50 000 and of a million triangles, 1280x720: the first picture of a cold
process, imports and loading included, and a further one in the same process. Budgets hold for two
idle cores.

Usage: python benchmarks/pictures.py [--peers PYTHON] [--rounds N]
"""

import argparse
import json
import math
import os
import struct
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import NamedTuple

OURS = """
import sys, time, resource
start = time.perf_counter()
from urdfkit.lint.loading import read
from urdfkit.render import build, place_camera, draw, render_image, save
file, target, quality, size = sys.argv[1:5]
size = tuple(map(int, size.split("x")))
scene = build(read(file))
save(render_image(scene, size=size, quality=quality), target)
first = time.perf_counter() - start, time.process_time()
again = time.perf_counter(), time.process_time()
if size[0] < 2000:
    draw(scene, place_camera(scene.points(), size=size), quality=quality)
"""
VTK = """
import sys, time, resource, math
start = time.perf_counter()
from vtkmodules.vtkIOGeometry import vtkSTLReader
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import *
from vtkmodules.vtkFiltersSources import *
from vtkmodules.vtkRenderingOpenGL2 import vtkEGLRenderWindow  # others ask for X
file, target = sys.argv[1].replace("robot.urdf", "knot.stl"), sys.argv[2]
def shown(source, colour, z):
    mapper = vtkPolyDataMapper(); mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor(); actor.SetMapper(mapper); actor.SetPosition(0, 0, z)
    actor.GetProperty().SetColor(*colour)
    return actor
reader = vtkSTLReader(); reader.SetFileName(file)
box = vtkCubeSource(); box.SetXLength(0.9); box.SetYLength(0.9); box.SetZLength(0.1)
scene = vtkRenderer(); scene.SetBackground(0.9, 0.9, 0.9)
scene.AddActor(shown(reader, (0.9, 0.5, 0.1), 0.6))
scene.AddActor(shown(box, (0.4, 0.45, 0.5), 0.05))
window = vtkEGLRenderWindow(); window.SetOffScreenRendering(1); window.SetSize(1280, 720)
window.SetMultiSamples(8); window.AddRenderer(scene)
scene.GetActiveCamera().SetPosition(3, 2, 2); scene.GetActiveCamera().SetViewUp(0, 0, 1)
scene.ResetCamera()
def drawn():
    window.Render()
    shot = vtkWindowToImageFilter(); shot.SetInput(window); shot.ReadFrontBufferOff()
    shot.Update()
    return shot
shot, writer = drawn(), vtkPNGWriter()
writer.SetFileName(target); writer.SetInputConnection(shot.GetOutputPort())
writer.Write()
first = time.perf_counter() - start, time.process_time()
scene.GetActiveCamera().Azimuth(1)
again = time.perf_counter(), time.process_time()
drawn()
"""
PYRENDER = """
import os, sys, time, resource
os.environ["PYOPENGL_PLATFORM"] = "egl"
start = time.perf_counter()
import numpy as np
np.infty = np.inf
import trimesh, pyrender
from PIL import Image
file, target = sys.argv[1].replace("robot.urdf", "knot.stl"), sys.argv[2]
scene = pyrender.Scene(bg_color=(0.9, 0.9, 0.9))
mesh = trimesh.load(file); mesh.apply_translation((0, 0, 0.6))
scene.add(pyrender.Mesh.from_trimesh(mesh))
scene.add(pyrender.Mesh.from_trimesh(trimesh.creation.box((0.9, 0.9, 0.1))))
pose = np.eye(4); pose[2, 3] = 3
scene.add(pyrender.PerspectiveCamera(0.5), pose=pose)
scene.add(pyrender.DirectionalLight(intensity=4), pose=pose)
renderer = pyrender.OffscreenRenderer(1280, 720)
Image.fromarray(renderer.render(scene)[0]).save(target)
first = time.perf_counter() - start, time.process_time()
again = time.perf_counter(), time.process_time()
renderer.render(scene)
"""
TOLD = """
import json
peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
print(json.dumps([first[0], first[1], time.perf_counter() - again[0],
                  time.process_time() - again[1], peak / 1024]))
"""

ROBOT = """<robot name="bench"><link name="base">
<visual><origin xyz="0 0 0.6"/><geometry><mesh filename="knot.stl"/></geometry>
<material name="orange"><color rgba="0.9 0.5 0.1 1"/></material></visual>
<visual><origin xyz="0 0 0.05"/><geometry><box size="0.9 0.9 0.1"/></geometry>
<material name="grey"><color rgba="0.4 0.45 0.5 1"/></material></visual>
<visual><origin xyz="0.3 -0.3 0.3"/>
<geometry><cylinder radius="0.08" length="0.4"/></geometry></visual>
<visual><origin xyz="-0.3 0.3 0.3"/><geometry><sphere radius="0.15"/></geometry></visual>
<visual><origin xyz="0.45 0 0.4"/><geometry><box size="0.01 0.8 0.6"/></geometry>
<material name="glass"><color rgba="0.3 0.8 0.9 0.3"/></material></visual>
</link></robot>"""


class Cost(NamedTuple):
    """Of a first picture and a further one, in s; the peak in MB."""

    first: float
    first_cpu: float
    further: float
    further_cpu: float
    peak: float


class Budget(NamedTuple):
    """A bound in s, or MB, for two idle cores."""

    title: str
    measured: float
    bound: float


def knot(path: Path, count: int) -> None:
    """A torus knot of about so many triangles, as binary STL."""
    sides = max(8, round(math.sqrt(count / 2) / 3))
    steps = count // (2 * sides)
    rings = [_ring(2 * math.pi * step / steps, sides) for step in range(steps)]
    with path.open("wb") as file:
        file.write(bytes(80) + struct.pack("<I", 2 * sides * steps))
        for step in range(steps):
            here, there = rings[step], rings[(step + 1) % steps]
            for side in range(sides):
                a, b = here[side], there[side]
                c, d = there[(side + 1) % sides], here[(side + 1) % sides]
                for three in ((a, b, c), (a, c, d)):
                    file.write(struct.pack("<12fH", 0, 0, 0, *three[0], *three[1], *three[2], 0))


def _ring(angle: float, sides: int) -> list[tuple[float, float, float]]:
    """Points around the curve of the knot, in m."""
    far = 2 + math.cos(3 * angle)
    x, y, z = far * math.cos(2 * angle), far * math.sin(2 * angle), math.sin(3 * angle)
    found = []
    for side in range(sides):
        turn = 2 * math.pi * side / sides
        out = 0.4 * math.cos(turn)
        found.append(
            (
                (x + out * math.cos(2 * angle)) / 6,
                (y + out * math.sin(2 * angle)) / 6,
                (z + 0.4 * math.sin(turn)) / 6,
            )
        )
    return found


def run(python: str, program: str, words: list[str], rounds: int) -> Cost | str:
    """The least cost of some runs; why it does not run here, if it does not."""
    found = []
    for _ in range(rounds):
        done = subprocess.run(
            [python, "-c", program + TOLD, *words],
            check=False,
            capture_output=True,
            text=True,
            env={**os.environ, "OPENBLAS_NUM_THREADS": "1"},
        )
        if done.returncode != 0:
            return (done.stderr.splitlines() or [f"exit code {done.returncode}"])[-1]
        found.append(Cost(*json.loads(done.stdout.splitlines()[-1])))
    return Cost(*(min(column) for column in zip(*found, strict=True)))


def measure(directory: Path, peers: str, rounds: int) -> list[Budget]:
    """Print what pictures cost; answer how that is beside the budgets."""
    picture = str(directory / "picture.png")
    ours: dict[tuple[str, str], Cost] = {}
    for title, count in (("50k", 45_000), ("1M", 995_000)):
        robot = directory / title / "robot.urdf"
        robot.parent.mkdir()
        robot.write_text(ROBOT, encoding="utf-8")
        knot(robot.parent / "knot.stl", count)
        print(f"\n{title} triangles, 1280x720     first s (CPU)   further s (CPU)   peak MB")
        contestants = [
            ("urdfkit", sys.executable, OURS, [str(robot), picture, "default", "1280x720"]),
            ("urdfkit draft", sys.executable, OURS, [str(robot), picture, "draft", "1280x720"]),
            ("pyrender", peers, PYRENDER, [str(robot), picture]),
            ("VTK", peers, VTK, [str(robot), picture]),
        ]
        for name, python, program, words in contestants:
            cost = run(python, program, words, rounds)
            show(name, cost, ours.get((title, "urdfkit")))
            if isinstance(cost, Cost):
                ours[title, name] = cost
    large = [str(directory / "50k" / "robot.urdf"), picture, "default", "3840x2160"]
    huge = run(sys.executable, OURS, large, 1)
    small, million = ours["50k", "urdfkit"], ours["1M", "urdfkit"]
    return [
        Budget("50k, first picture, s", small.first, 1.5),
        Budget("50k, a further picture, s", small.further, 1.0),
        Budget("50k, a further draft, s", ours["50k", "urdfkit draft"].further, 0.4),
        Budget("1M, first picture, s", million.first, 1.4 * 1.5),
        Budget("1M, a further picture, s", million.further, 1.4 * 1.0),
        Budget("3840x2160, MB", huge.peak if isinstance(huge, Cost) else math.inf, 1024),
    ]


def show(name: str, cost: Cost | str, ours: Cost | None) -> None:
    """One line of the table, with the ratio of ours to a peer."""
    if isinstance(cost, str):
        print(f"  {name:<24} does not run here: {cost}")
        print(f"  {'':<24} python -m venv peers && peers/bin/pip install pyrender vtk,")
        print(f"  {'':<24} apt-get install libegl1, and --peers peers/bin/python")
        return
    first, further = (
        f"{cost.first:.2f} ({cost.first_cpu:.2f})",
        f"{cost.further:.2f} ({cost.further_cpu:.2f})",
    )
    ratio = (
        f"   we take {ours.first / cost.first:.1f}x, {ours.further / cost.further:.1f}x"
        if ours
        else ""
    )
    print(f"  {name:<24} {first:<15} {further:<17} {cost.peak:.0f}{ratio}")


def main() -> int:
    """Measure and print; 1 if a budget is exceeded."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--peers", default=sys.executable, metavar="PYTHON")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        budgets = measure(Path(scratch), options.peers, options.rounds)
    print("\nBudgets, for two idle cores")
    for budget in budgets:
        verdict = "pass" if budget.measured <= budget.bound else "OVER"
        print(f"{verdict}  {budget.title}: {budget.measured:.2f} of {budget.bound:.2f}")
    return int(any(budget.measured > budget.bound for budget in budgets))


if __name__ == "__main__":
    sys.exit(main())
