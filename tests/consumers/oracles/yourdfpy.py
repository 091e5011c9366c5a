"""yourdfpy, with the meshes of visuals and collisions."""

from tests.consumers.reading import Reading

PACKAGE = "yourdfpy"
MODULE = "yourdfpy"

CAUSES = {
    r"list\.remove": ("repeated name", "NAM001"),
    "No path from": ("a link without a place", "REF001 NAM001"),
    "could not convert string": ("number", "URD005"),
    "Iteration limit": ("cycle", "TRE003"),
    "'NoneType' object": ("missing part", "URD003 URD004"),
    "DaeMalformedError": ("broken mesh", "MSH009"),
}


def read(path: str) -> Reading:
    """What it makes of a URDF."""
    import yourdfpy

    urdf = yourdfpy.URDF.load(
        path, build_collision_scene_graph=True, load_meshes=True, load_collision_meshes=True
    )
    frames = {}
    for link in urdf.link_map:
        place = urdf.get_transform(link)
        frames[link] = [*place[:3, 3].tolist(), *place[:3, :3].flatten().tolist()]
    inertials = [link.inertial for link in urdf.robot.links]
    return Reading(sum(one.mass or 0.0 for one in inertials if one), frames)
