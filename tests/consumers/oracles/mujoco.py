"""MuJoCo: the loader of ``mujoco.MjModel``."""

from tests.consumers.reading import Reading

PACKAGE = "mujoco"
MODULE = "mujoco"

_NOT_FOUND = "MSH001 MSH039 XAC011"

CAUSES = {
    "Error opening file": ("mesh not found", _NOT_FOUND),
    "no decoder found": ("mesh format", "MSH007"),
    r"stl_decoder": ("STL that it does not load", "MSH007 MSH009 MSH019"),
    r"mesh (volume|surface)|vertices": ("mesh without volume", "MSH015 MSH009 GEO001"),
    r"A \+ B >= C": ("triangle inequality", "INE003"),
    "positive eigenvalues": ("singular inertia", "INE003 INE005"),
    "mass and inertia of moving": ("no mass or inertia", "INE001 INE004 INE005"),
    "repeated element": ("repeated element", "URD007"),
    "repeated (URDF )?name": ("repeated name", "NAM001"),
    "parent or child missing": ("unknown link", "REF001"),
    "multiple parents": ("two parents", "TRE004"),
    "body not found": ("cycle", "TRE003"),
    "missing element|required attribute": ("missing part", "URD001 URD003 URD004 GEO002"),
    "geometry specification": ("unknown shape", "URD001 URD004 GEO002"),
    r"size \d must be positive": ("size", "GEO001"),
    "bad format|enough data|too much data|problem reading": ("number", "URD005"),
    "axis too small": ("axis of length 0", "JNT006"),
    "invalid joint type": ("joint type", "JNT001"),
}


def read(path: str) -> Reading:
    """What it makes of a URDF; links that it merges have no frame."""
    import mujoco

    model = mujoco.MjModel.from_xml_path(path)
    data = mujoco.MjData(model)
    data.qpos[:] = 0
    for joint in range(model.njnt):  # of a free or ball joint, the quaternion
        start = model.jnt_qposadr[joint]
        if model.jnt_type[joint] == mujoco.mjtJoint.mjJNT_FREE:
            data.qpos[start + 3] = 1
        elif model.jnt_type[joint] == mujoco.mjtJoint.mjJNT_BALL:
            data.qpos[start] = 1
    mujoco.mj_kinematics(model, data)
    bodies = [model.body(number) for number in range(1, model.nbody)]
    frames = {
        body.name: [*data.xpos[body.id].tolist(), *data.xmat[body.id].tolist()] for body in bodies
    }
    return Reading(float(model.body_mass.sum()), frames)
