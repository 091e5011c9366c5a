"""A closed mesh, or a piece of one, is inside out.

The vertices of a triangle are in counter-clockwise order as seen from outside. In this mesh they
are clockwise: its volume is negative, so that tools which compute a mass from it fail or get a
negative one, MuJoCo rejects it, renderers that draw front faces only show the far inside, and its
shading is wrong. It comes from a mirrored part or from the export. `urdfkit mesh repair` flips it.

Sources:
    STL: https://en.wikipedia.org/wiki/STL_(file_format)
    MuJoCo, user_mesh.cc: https://github.com/google-deepmind/mujoco/blob/main/src/user/user_mesh.cc
"""

from __future__ import annotations

from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, Need, rule
from urdfkit.mesh.samples import BOX, box, stl
from urdfkit.robot.assets.mesh_defects import MeshDefect
from urdfkit.robot.samples import mesh_xml
from urdfkit.text.diagnostic import Severity

BAD = mesh_xml("collision", "forearm.stl")
GOOD = BAD.replace("forearm", "hand")
FILES = {
    "forearm.stl": stl(box((0, 0, 0), (0.1, 0.1, 0.3), (face[::-1] for face in BOX))),
    "hand.stl": stl(box((0, 0, 0), (0.1, 0.1, 0.3))),
}


@rule(Severity.WARNING, needs=(Need.MODEL, Need.MESHES), help="urdfkit mesh repair FILE")
def check(subject: Subject) -> Findings:
    for use in subject.measured.defects.get(MeshDefect.INVERTED, ()):
        found = use.measures
        what = "its triangles face inwards"
        if found.bodies > 1 and found.inverted_bodies:
            what = f"{found.inverted_bodies} of its {found.bodies} pieces face inwards"
        yield Finding(use.at, f"{use.who} is inside out: {what}", alike="inside out")
