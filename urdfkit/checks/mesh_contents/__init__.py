"""What the mesh files of a robot contain."""

from __future__ import annotations

from urdfkit.lint.context import Subject

#: Former codes and names, and the rules that report their findings now.
REDIRECTS = {
    "MSH018": "MSH007", "binary-stl-starts-with-solid": "MSH007",
    "MSH016": "MSH015", "inverted-mesh": "MSH015",
    "MSH008": "MSH009", "empty-mesh": "MSH009", "MSH010": "MSH009", "not-a-mesh": "MSH009",
    "MSH011": "MSH009", "truncated-mesh": "MSH009", "MSH026": "MSH009",
    "non-finite-vertices": "MSH009", "MSH034": "MSH009", "mesh-partly-unreadable": "MSH009",
    "MSH038": "MSH012", "shrunk-to-a-grain": "MSH012",
    "collada-unit-not-metre": "MSH013", "MSH014": "MSH013", "collada-up-axis": "MSH013",
    "MSH035": "MSH013", "gltf-up-axis": "MSH013",
    "open-mesh": "MSH015", "MSH022": "MSH015", "self-intersecting": "MSH015", "MSH033": "MSH015",
    "zero-volume-part": "MSH015",
    "dense-collision-mesh": "MSH019", "MSH020": "MSH019", "dense-visual-mesh": "MSH019",
    "MSH031": "MSH019", "collision-is-the-visual-mesh": "MSH019",
    "MSH037": "MSH021", "missing-materials": "MSH021",
    "MSH028": "MSH029", "stl-colour-lost": "MSH029", "collada-extras-ignored": "MSH029",
    "MSH023": "", "several-bodies": "", "MSH027": "", "case-collision": "", "MSH030": "",
    "unreferenced-mesh-file": "", "MSH032": "", "far-from-link-origin": "",
}  # fmt: skip


def applies(subject: Subject) -> bool:
    """True if a mesh file is there."""
    return any(mesh.facts for mesh in subject.files.meshes)
