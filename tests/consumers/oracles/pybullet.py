"""PyBullet: ``loadURDF``."""

from tests.consumers.reading import Reading

PACKAGE = "pybullet"
MODULE = "pybullet"

CAUSES = {
    "Could not parse (visual|collision)": ("mesh not found", "MSH001 XAC011 URD003"),
    "(parent|child) link for a joint": ("unknown link", "REF001"),
    "not unique": ("repeated name", "NAM001"),
    r"UrdfImporter\.cpp,121\]:$": ("process ends", "NAM001"),
    r"Cannot load URDF file": ("cycle", "TRE003"),
}


def read(path: str) -> Reading:
    """What it makes of a URDF."""
    import pybullet

    pybullet.connect(pybullet.DIRECT)
    robot = pybullet.loadURDF(path, useFixedBase=True)
    root = pybullet.getBodyInfo(robot)[0].decode()
    frames = {root: [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]}
    mass = pybullet.getDynamicsInfo(robot, -1)[0]
    for number in range(pybullet.getNumJoints(robot)):
        name = pybullet.getJointInfo(robot, number)[12].decode()
        state = pybullet.getLinkState(robot, number)
        frames[name] = [*state[4], *pybullet.getMatrixFromQuaternion(state[5])]
        mass += pybullet.getDynamicsInfo(robot, number)[0]
    return Reading(mass, frames)
