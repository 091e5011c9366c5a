"""Contents of the mesh files of a robot."""

from urdfkit.lint.context import Context


def applies(context: Context) -> bool:
    """True if a mesh file exists."""
    return any(mesh.facts for mesh in context.files.meshes)
