"""How the cost of each command grows with the robot and with the mesh: seconds, memory, exponent.

Robots are a chain and a star of links, meshes are bumpy spheres. The cost of a command is the
processor time of its process and of those that it starts, and the greatest memory that one of them
takes. The exponent is that of the two largest sizes, the cost of the smallest one taken off.
"""

import argparse
import os
import resource
import struct
import sys
import tempfile
from collections.abc import Iterable
from math import log
from pathlib import Path
from typing import NamedTuple

LINKS = (10, 100, 1000, 5000)
#: A file of 10**7 triangles is larger than urdfkit reads.
TRIANGLES = (10**3, 2 * 10**5, 10**6, 2 * 10**6)
#: Joints that Pinocchio has memory for; the pairs of links, which are compared, grow as the square.
FEWER = {
    "statics": (10, 50, 150),
    "collisions": (10, 25, 50),
    "convert-mjcf": (10, 50, 150),
}
#: Seconds after which a command is given up.
LIMIT = 600
#: An exponent beyond it has a reason, or is a defect.
MOST = 1.2

ROBOT_COMMANDS = {
    "check": "check {} --no-cache --jobs 1",
    "expand": "expand {}",
    "info": "info {}",
    "tree": "tree {}",
    "mass": "mass {}",
    "kinematics": "kinematics {}",
    "statics": "statics {} --samples 20",
    "collisions": "collisions {} --samples 100 --jobs 1",
    "render": "render {} -o {}.png --size 320x240",
    "report": "report {} --quick -o {}.html",
    "importers": "importers {}",
    "convert-urdf": "convert {} --to urdf -o {}.urdf.out --force",
    "convert-sdf": "convert {} --to sdf -o {}.sdf.out --force",
    "convert-mjcf": "convert {} --to mjcf -o {}.mjcf.out --force",
    "format": "format {} --check",
    "fix": "fix {} --diff",
}
MESH_COMMANDS = {
    "info": "mesh info {}",
    "convert": "mesh convert {} {}.ply --force",
    "repair": "mesh repair {} -o {}.stl --force",
    "hull": "mesh hull {} -o {}.stl --force",
    "simplify": "mesh simplify {} --triangles 500 -o {}.stl --force",
}
#: Limits that would end a measurement.
LIFTED = " --timeout 1000000 --memory 1000"
WITH_LIMITS = (
    *("info", "mass", "kinematics", "statics", "collisions", "render", "report"),
    *("convert-urdf", "convert-sdf", "convert-mjcf"),
)

_LINK = """\
  <link name="l{n}">
    <inertial><mass value="1"/>
      <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
    <visual><geometry><box size="0.05 0.05 0.05"/></geometry></visual>
    <collision><geometry><box size="0.05 0.05 0.05"/></geometry></collision>
  </link>
"""
_JOINT = """\
  <joint name="j{n}" type="revolute">
    <origin xyz="{x} {y} 0.1"/><parent link="l{parent}"/><child link="l{n}"/><axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="1000" velocity="1"/>
  </joint>
"""


class Cost(NamedTuple):
    """Of one command: processor time in s, memory in MiB, and whether it came to its end."""

    seconds: float
    memory: float
    is_done: bool


def robot(shape: str, links: int) -> str:
    """A URDF: in a chain, each link carries the next one; in a star, the first carries all."""
    parts = ['<robot name="r">\n', _LINK.format(n=0)]
    for n in range(1, links):
        parent, x, y = (n - 1, 0, 0) if shape == "chain" else (0, 0.1 * (n % 70), 0.1 * (n // 70))
        parts += [_LINK.format(n=n), _JOINT.format(n=n, parent=parent, x=x, y=y)]
    return "".join([*parts, "</robot>\n"])


def write_sphere(path: Path, triangles: int) -> None:
    """A binary STL of about so many triangles: a sphere with bumps."""
    import numpy as np

    across = max(4, round((triangles / 4) ** 0.5))
    u, v = np.meshgrid(np.linspace(0, np.pi, across + 1), np.linspace(0, 2 * np.pi, 2 * across + 1))
    v[-1] = 0.0  # where the surface closes
    radius = 1 + 0.01 * np.sin(20 * u) * np.sin(20 * v)
    sine = np.where((u == 0) | (u == np.pi), 0.0, np.sin(u))
    place = np.stack([radius * sine * np.cos(v), radius * sine * np.sin(v), radius * np.cos(u)], -1)
    a, b, c, d = place[:-1, :-1], place[:-1, 1:], place[1:, 1:], place[1:, :-1]
    first = np.stack([a, b, c], 2)[:, 1:].reshape(-1, 3, 3)  # at the poles, one of the two is flat
    second = np.stack([a, c, d], 2)[:, :-1].reshape(-1, 3, 3)
    corners = np.concatenate([first, second]).astype("<f4")
    rows = np.zeros(len(corners), dtype=[("n", "<f4", 3), ("c", "<f4", (3, 3)), ("a", "<u2")])
    rows["c"] = corners
    path.write_bytes(bytes(80) + struct.pack("<I", len(rows)) + rows.tobytes())


def cost(command: str, limit: int) -> Cost:
    """What a command line of urdfkit costs."""
    process = os.fork()
    if process == 0:
        resource.setrlimit(resource.RLIMIT_CPU, (limit, limit))
        null = os.open(os.devnull, os.O_RDWR)
        for stream in (0, 1, 2):
            os.dup2(null, stream)
        os.execv(sys.executable, [sys.executable, "-m", "urdfkit", *command.split()])
    _, status, used = os.wait4(process, 0)
    ended = os.WIFEXITED(status) and os.WEXITSTATUS(status) in (0, 1)
    seconds = used.ru_utime + used.ru_stime
    return Cost(seconds, used.ru_maxrss / 1024, ended and seconds < limit)


def exponent(sizes: list[int], values: list[float]) -> float:
    """Of the power by which values grow between the last two sizes.

    The first value is taken off, unless the second of the two is hardly more than it.
    """
    before, after = values[-2:]
    if before > 2 * values[0]:
        before, after = before - values[0], after - values[0]
    return log(after / before) / log(sizes[-1] / sizes[-2])


def measure(title: str, command: str, files: dict[int, Path], limit: int) -> bool:
    """Print a row about one command; True if it grows no faster than it may."""
    sizes: list[int] = []
    costs: list[Cost] = []
    for size, path in files.items():
        found = cost(command.replace("{}", str(path)), limit)
        if not found.is_done:
            print(f"{title:22} failed at {size} after {found.seconds:.0f} s", flush=True)
            break
        sizes.append(size)
        costs.append(found)
    cells = "".join(f"{one.seconds:9.2f} s {one.memory:6.0f} MiB" for one in costs)
    if len(costs) < 3:
        print(f"{title:22}{cells}", flush=True)
        return False
    time = exponent(sizes, [one.seconds for one in costs])
    memory = exponent(sizes, [one.memory for one in costs])
    verdict = "" if time <= MOST else "  OVER"
    print(f"{title:22}{cells}  time^{time:.2f} memory^{memory:.2f}{verdict}", flush=True)
    return time <= MOST


def measure_robots(folder: Path, sizes: Iterable[int], chosen: set[str], limit: int) -> bool:
    """A row for each command and shape of robot; True if all grow no faster than they may."""
    kept = True
    for shape in ("chain", "star"):
        for name, command in ROBOT_COMMANDS.items():
            if not chosen or name in chosen:
                files = {}
                for links in FEWER.get(name, sizes):
                    files[links] = folder / f"{shape}{links}.urdf"
                    files[links].write_text(robot(shape, links))
                line = command + (LIFTED if name in WITH_LIMITS else "")
                kept &= measure(f"{shape} {name}", line, files, limit)
    return kept


def measure_meshes(folder: Path, sizes: Iterable[int], chosen: set[str], limit: int) -> bool:
    """A row for each mesh command; True if all grow no faster than they may."""
    kept = True
    files = {size: folder / f"sphere{size}.stl" for size in sizes}
    for size, path in files.items():
        write_sphere(path, size)
    for name, command in MESH_COMMANDS.items():
        if not chosen or f"mesh-{name}" in chosen:
            kept &= measure(f"mesh {name}", command + LIFTED, files, limit)
    return kept


def main() -> int:
    """Measure, print, and answer 1 if a command grows faster than it may."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("commands", nargs="*", help="such as check, or mesh-info; all if none")
    parser.add_argument("--links", type=int, nargs="*", default=LINKS)
    parser.add_argument("--triangles", type=int, nargs="*", default=TRIANGLES)
    parser.add_argument("--limit", type=int, default=LIMIT, help="seconds of a command")
    options = parser.parse_args()
    chosen = set(options.commands)
    kept = True
    with tempfile.TemporaryDirectory() as folder:
        if not chosen or chosen & set(ROBOT_COMMANDS):
            kept &= measure_robots(Path(folder), options.links, chosen, options.limit)
        if not chosen or any(name.startswith("mesh-") for name in chosen):
            kept &= measure_meshes(Path(folder), options.triangles, chosen, options.limit)
    return int(not kept)


if __name__ == "__main__":
    sys.exit(main())
