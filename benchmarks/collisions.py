"""What ``urdfkit collisions`` costs beside a plain loop over Pinocchio's ``computeCollisions``.

Usage: python benchmarks/collisions.py [--shared DIRECTORY] [--rounds N]

The loop is what one writes by hand: all pairs that Pinocchio offers, each tested in each sample. It
is measured in a part of the samples, after its meshes are loaded, and scaled to all of them.
urdfkit is measured with everything: the processes that it starts, meshes, hulls, distances. CPU
seconds of all processes together; the rounds take turns, and the least of each counts.
"""

import argparse
import resource
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pinocchio as pin

from urdfkit.lint.context import Context
from urdfkit.lint.loading import read
from urdfkit.mesh.geometry import Floats
from urdfkit.physics.collision.batch_kinematics import tree_arrays
from urdfkit.physics.collision.sampling import collisions
from urdfkit.robot.adjacency import Adjacency

ROOT = Path(__file__).resolve().parents[1]
SAMPLES = 10_000
#: Of them, those that the loops are measured in.
PART = 200

#: Directory of the package, its name, and the robot in it.
ROBOTS = {
    "panda": ("panda_description", "moveit_resources_panda_description", "urdf/panda.urdf"),
    "fanuc": ("fanuc_description", "moveit_resources_fanuc_description", "urdf/fanuc.urdf"),
}
#: At least so many times faster than the loop over all pairs.
BUDGET = {"panda": 20.0}


class Loop(NamedTuple):
    """The robot in Pinocchio, and the same samples as configurations of it."""

    model: Any
    data: Any
    geometry: Any
    rows: Floats

    def collisions(self) -> None:
        """Whether each pair collides, in every sample."""
        results = self.geometry.createData()
        for request in results.collisionRequests:
            request.security_margin = 1e-6  # without it hits are missed
        for row in self.rows:
            pin.computeCollisions(self.model, self.data, self.geometry, results, row, False)

    def distances(self) -> None:
        """How far the pairs are apart, in every tenth sample."""
        results = self.geometry.createData()
        for row in self.rows[::10]:
            pin.computeDistances(self.model, self.data, self.geometry, results, row)


def loop(context: Context, package: Path, name: str, scratch: Path, *, all_pairs: bool) -> Loop:
    """Pinocchio's model with the pairs of a loop: all, or those that urdfkit samples."""
    if not (scratch / name).exists():
        (scratch / name).symlink_to(package)
    path = context.source.path
    model = pin.buildModelFromUrdf(path)
    geometry = pin.buildGeomFromUrdf(
        model, path, pin.GeometryType.COLLISION, package_dirs=[str(scratch)]
    )
    adjacency = Adjacency(context.tree)
    links = [model.frames[thing.parentFrame].name for thing in geometry.geometryObjects]
    for first in range(len(links)):
        for second in range(first + 1, len(links)):
            if all_pairs or not adjacency.is_adjacent(links[first], links[second]):
                geometry.addCollisionPair(pin.CollisionPair(first, second))
    return Loop(model, model.createData(), geometry, configurations(context, model))


def configurations(context: Context, model: Any) -> Floats:
    """The first samples of urdfkit as Pinocchio has them: its followers have columns, too."""
    arrays = tree_arrays(context.tree)
    rows = arrays.samples(PART, 0, 0)
    found = np.zeros((PART, model.nq))
    columns = {axis.joint: column for column, axis in enumerate(arrays.axes)}
    for joint in context.model.joints:
        leader = joint.mimic.joint.value if joint.mimic and joint.mimic.joint else joint.name
        if leader in columns:
            found[:, model.joints[model.getJointId(joint.name)].idx_q] = rows[:, columns[leader]]
    return found


def cpu(job: Callable[[], object]) -> float:
    """CPU seconds of a job and the processes that it starts."""
    before = _spent()
    job()
    return _spent() - before


def _spent() -> float:
    both = (resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    return sum(one.ru_utime + one.ru_stime for one in both)


def measure(name: str, shared: Path, scratch: Path, rounds: int) -> float:
    """Print the costs for one robot; how many times faster urdfkit is than the plain loop."""
    directory, package, file = ROBOTS[name]
    place = shared / "corpus" / "moveit_resources" / directory
    context = read(place / file)
    plain = loop(context, place, package, scratch, all_pairs=True)
    same = loop(context, place, package, scratch, all_pairs=False)
    scale = SAMPLES / PART
    jobs: dict[str, tuple[float, Callable[[], object]]] = {
        "loop, all pairs, collisions": (scale, plain.collisions),
        "loop, sampled pairs, collisions": (scale, same.collisions),
        "loop, sampled pairs, distances": (10 * scale, same.distances),
        "urdfkit, 1 process": (1.0, lambda: collisions(read(place / file), jobs=1)),
    }
    least = dict.fromkeys(jobs, float("inf"))
    for _ in range(rounds):
        for title, (factor, job) in jobs.items():
            least[title] = min(least[title], factor * cpu(job))
    own = least["urdfkit, 1 process"]
    for title, seconds in least.items():
        print(f"{name:<6} {title:<32} {seconds:7.2f} s  {seconds / own:6.1f} x urdfkit")
    start = time.perf_counter()
    collisions(read(place / file))
    print(f"{name:<6} {'urdfkit, all processors, wall':<32} {time.perf_counter() - start:7.2f} s")
    return least["loop, all pairs, collisions"] / own


def main() -> int:
    """Measure, print, and answer 1 if the budget is exceeded."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--shared", type=Path, default=ROOT.parent / "shared", metavar="DIRECTORY")
    options = parser.parse_args()
    if not (options.shared / "corpus").is_dir():
        print(f"{options.shared} has no corpus of real robots")
        return 0
    failed = False
    with tempfile.TemporaryDirectory() as scratch:
        for name in ROBOTS:
            ratio = measure(name, options.shared, Path(scratch), options.rounds)
            if ratio < BUDGET.get(name, 0):
                print(f"{name}: {ratio:.1f} x is less than {BUDGET[name]:g} x")
                failed = True
    return int(failed)


if __name__ == "__main__":
    sys.exit(main())
