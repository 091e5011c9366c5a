"""Drake: its parser, with the scene graph that collides."""

from pathlib import Path

from tests.consumers.reading import Reading

PACKAGE = "drake"
MODULE = "pydrake.multibody.parsing"

CAUSES = {
    "MakeConvexHull": ("mesh format", "MSH007"),
    "unknown package|does not exist": ("file not found", "MSH001 XAC011"),
    "not previously defined": ("unknown material", "REF003"),
    "Could not find link": ("unknown link", "REF001"),
    "already contains a body": ("repeated name", "NAM001"),
    "is not allowed|to itself": ("cycle", "TRE003"),
}


def read(path: str) -> Reading:
    """What it makes of a URDF."""
    from pydrake.multibody.parsing import Parser
    from pydrake.multibody.plant import AddMultibodyPlantSceneGraph
    from pydrake.systems.framework import DiagramBuilder

    builder = DiagramBuilder()
    plant, _ = AddMultibodyPlantSceneGraph(builder, 0.001)
    instances = Parser(plant).AddModels(Path(path))
    plant.Finalize()
    diagram = builder.Build()
    context = plant.GetMyContextFromRoot(diagram.CreateDefaultContext())
    frames = {}
    mass = 0.0
    for body in map(plant.get_body, plant.GetBodyIndices(instances[0])):
        place = plant.EvalBodyPoseInWorld(context, body)
        matrix = place.rotation().matrix()
        frames[body.name()] = [*place.translation().tolist(), *matrix.flatten().tolist()]
        mass += body.default_mass()
    return Reading(mass, frames)
