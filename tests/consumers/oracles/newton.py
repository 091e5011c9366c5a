"""Newton: the importer of its builder, and the model that is made of it."""

from tests.consumers.reading import Reading

PACKAGE = "newton"
MODULE = "newton"

CAUSES = {
    "XML declaration not well-formed": ("XML declaration", "XML007"),
    "not found in URDF": ("unknown link", "REF001"),
    "could not convert string": ("number", "URD005"),
    "Multiple joints lead": ("two parents", "TRE004 NAM001"),
    "No root found": ("cycle", "TRE003"),
    "'NoneType' object": ("missing part", "URD003 URD004"),
    "DaeMalformedError": ("broken mesh", "MSH009"),
}


def read(path: str) -> Reading:
    """What it makes of a URDF."""
    import newton
    import numpy
    import warp

    warp.config.quiet = True
    builder = newton.ModelBuilder()
    builder.add_urdf(path)
    model = builder.finalize(device="cpu")
    state = model.state()
    newton.eval_fk(model, model.joint_q, model.joint_qd, state)
    frames = {}
    for label, place in zip(model.body_label, state.body_q.numpy().tolist(), strict=True):
        matrix = numpy.array(warp.quat_to_matrix(warp.quat(*place[3:])))
        frames[label.partition("/")[2] or label] = [*place[:3], *matrix.flatten().tolist()]
    return Reading(float(model.body_mass.numpy().sum()), frames)
