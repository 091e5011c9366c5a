"""A mesh file contains data that URDF programs ignore.

Modelling programs also export lines, cameras, lights, bones and animations. RViz does not show
them, and Gazebo Classic has drawn the lines as thick wire frames. They cost time to load. Export
only the selected mesh, or convert the file with `urdfkit mesh convert`, which keeps only the
triangles.

Some CAD programs store a colour in two spare bytes of each triangle of an STL file, in one of two
incompatible formats. RViz, Gazebo and Python tools ignore the colour and show the part in the
colour of its `<material>`, or grey. Give the visual a `<material>`, or export COLLADA.

Sources:
    COLLADA 1.4: https://www.khronos.org/files/collada_spec_1_4.pdf
    Gazebo Classic, ColladaLoader.cc: https://github.com/gazebosim/gazebo-classic/blob/gazebo11/gazebo/common/ColladaLoader.cc
    STL: https://en.wikipedia.org/wiki/STL_(file_format)
"""

from urdfkit.lint.rules import Context, Finding, Findings, Need, Severity, rule
from urdfkit.mesh.samples import collada
from urdfkit.robot.assets.mesh_defects import COLOURS, MeshDefect, extras
from urdfkit.robot.samples import mesh_xml

BAD = mesh_xml("visual", "forearm.dae")
GOOD = BAD.replace("forearm", "hand")
FILES = {
    "forearm.dae": collada(
        more="""<lines count="1">
      <input semantic="VERTEX" source="#corners" offset="0"/><p>0 1</p></lines>"""
    ),
    "hand.dae": collada(),
}


@rule(
    Severity.INFO,
    needs=(Need.MODEL, Need.MESHES),
    help="export the mesh alone, or urdfkit mesh convert FILE -o NEW.dae",
)
def check(context: Context) -> Findings:
    defects = context.measured.defects
    for use in defects.get(MeshDefect.EXTRAS, ()):
        content = ", ".join(extras(use))
        message = f"{use.who} also contains {content}; only triangles are shown"
        yield Finding(use.at, message, group_key=content)
    for use in defects.get(MeshDefect.STL_COLOURS, ()):
        (colours,) = (extra for extra in use.measures.extras if extra.startswith(COLOURS))
        message = f"{use.who} contains {colours}, which URDF programs ignore"
        help = "give the visual a <material>, or export COLLADA"
        yield Finding(use.at, message, help, group_key="colours")
