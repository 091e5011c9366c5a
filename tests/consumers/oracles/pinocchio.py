"""Pinocchio: its model, and the geometry of visuals and collisions."""

from tests.consumers.reading import Reading

PACKAGE = "pin"
MODULE = "pinocchio"

CAUSES = {
    "could not be found|Unable to open file": ("mesh not found", "MSH001 XAC011"),
    "Could not load resource": ("broken mesh", "MSH009"),
    "Two root links": ("several roots", "TRE002"),
    "No root link": ("cycle", "TRE003"),
    "is not unique": ("repeated name", "NAM001"),
    "must contain a filename": ("missing part", "URD003"),
    "Unable to parse component": ("number", "URD005"),
    "parent link|child link": ("unknown link", "REF001"),
}


def read(path: str) -> Reading:
    """What it makes of a URDF."""
    import pinocchio

    model = pinocchio.buildModelFromUrdf(path)
    for kind in (pinocchio.GeometryType.COLLISION, pinocchio.GeometryType.VISUAL):
        pinocchio.buildGeomFromUrdf(model, path, kind)
    data = model.createData()
    pinocchio.framesForwardKinematics(model, data, pinocchio.neutral(model))
    frames = {
        frame.name: [*place.translation.tolist(), *place.rotation.flatten().tolist()]
        for frame, place in zip(model.frames, data.oMf, strict=True)
        if frame.type == pinocchio.FrameType.BODY
    }
    return Reading(sum(inertia.mass for inertia in model.inertias), frames)
