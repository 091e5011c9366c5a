"""What the mesh files of a robot contain."""

from urdfkit.lint.context import Context


def applies(context: Context) -> bool:
    """True if a mesh file is there."""
    return any(mesh.facts for mesh in context.files.meshes)
