"""What libsdformat itself makes of a robot."""

import shutil
import subprocess
import tempfile
from hashlib import sha256
from pathlib import Path
from typing import NamedTuple

import pytest

DUMP = r"""
#include <sdf/sdf.hh>
#include <iomanip>
#include <iostream>
using std::cout, std::string;
static void names(const sdf::ElementPtr &link, const string &kind) {
  if (!link->HasElement(kind)) return;
  for (auto e = link->GetElement(kind); e; e = e->GetNextElement(kind))
    cout << kind << "\t" << e->Get<string>("name") << "\n";
}
int main(int count, char **files) {
  sdf::Console::Instance()->SetQuiet(true);
  cout << std::setprecision(15);
  for (int i = 1; i < count; ++i) {
    sdf::SDFPtr robot(new sdf::SDF());
    sdf::init(robot);
    sdf::Errors errors;
    cout << "file\t" << files[i] << "\n";
    if (!sdf::readFile(files[i], robot, errors) || !robot->Root()->HasElement("model")) continue;
    auto model = robot->Root()->GetElement("model");
    if (model->HasElement("link"))
      for (auto l = model->GetElement("link"); l; l = l->GetNextElement("link")) {
        cout << "link\t" << l->Get<string>("name");
        if (l->HasElement("inertial")) {
          auto inertial = l->GetElement("inertial");
          auto at = inertial->Get<ignition::math::Pose3d>("pose").Pos();
          auto moments = inertial->GetElement("inertia");
          cout << "\t" << inertial->Get<double>("mass") << "\t" << at.X() << "\t" << at.Y() << "\t"
               << at.Z() << "\t"
               << moments->Get<double>("ixx") + moments->Get<double>("iyy") +
                      moments->Get<double>("izz");
        }
        cout << "\n";
        names(l, "collision");
        names(l, "visual");
      }
    if (model->HasElement("joint"))
      for (auto j = model->GetElement("joint"); j; j = j->GetNextElement("joint"))
        cout << "joint\t" << j->Get<string>("name") << "\t" << j->Get<string>("type") << "\t"
             << j->Get<string>("parent") << "\t" << j->Get<string>("child") << "\n";
  }
}
"""


class Simulated(NamedTuple):
    """A model as libsdformat converts it."""

    links: dict[str, tuple[float, ...]]
    joints: dict[str, tuple[str, ...]]
    collisions: list[str]
    visuals: list[str]


def build(directory: Path) -> Path:
    """A program that prints what libsdformat makes of URDF files."""
    return compiled(DUMP, "sdformat12", directory)


def compiled(code: str, package: str, directory: Path) -> Path:
    """A C++ program with libsdformat, compiled once into a directory.

    The test is skipped where this package of pkg-config or a compiler is missing.
    """
    flags = pkg_config("--cflags", "--libs", package).split()
    if not flags or not shutil.which("g++"):
        pytest.skip("g++ and libsdformat (Debian: libsdformat-dev) are not installed")
    program = directory / sha256(code.encode()).hexdigest()
    if not program.exists():
        directory.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=directory) as scratch:  # another process may, too
            built = Path(scratch) / "program"
            built.with_suffix(".cc").write_text(code)
            subprocess.run(
                ["g++", "-std=c++17", "-O0", str(built.with_suffix(".cc")), "-o", built, *flags],
                check=True,
                capture_output=True,
            )
            built.replace(program)
    return program


def pkg_config(*words: str) -> str:
    """The output of pkg-config; empty if it fails or is not installed."""
    if shutil.which("pkg-config") is None:
        return ""
    done = subprocess.run(["pkg-config", *words], capture_output=True, text=True, check=False)
    return done.stdout if done.returncode == 0 else ""


def convert(program: Path, directory: Path, text: str) -> Simulated:
    file = directory / "robot.urdf"
    file.write_text(text)
    lines = subprocess.run([program, file], capture_output=True, text=True, check=True).stdout
    simulated = Simulated({}, {}, [], [])
    for line in lines.splitlines():
        kind, name, *rest = line.split("\t")
        if kind == "link":
            simulated.links[name] = tuple(map(float, rest))
        elif kind == "joint":
            simulated.joints[name] = tuple(rest)
        elif kind in ("collision", "visual"):
            getattr(simulated, f"{kind}s").append(name)
    return simulated
