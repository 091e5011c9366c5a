"""What programs themselves make of a URDF: each in a process of its own, as some end theirs."""

import importlib.util
import json
import os
from pathlib import Path
from typing import Any

from tests.consumers.reading import run

_MUJOCO = """
import mujoco, numpy as np
model = mujoco.MjModel.from_xml_path(path)
joints = [
    (model.joint(i).name, int(model.jnt_qposadr[i]), int(model.jnt_dofadr[i]))
    for i in range(model.njnt)
]
bodies = {}
for i in range(1, model.nbody):
    turn = np.zeros(9)
    mujoco.mju_quat2Mat(turn, model.body_iquat[i])
    turn = turn.reshape(3, 3)
    tensor = turn @ np.diag(model.body_inertia[i]) @ turn.T
    bodies[model.body(i).name] = (
        float(model.body_mass[i]), *map(float, model.body_ipos[i]), *map(float, tensor.flat)
    )
"""

_PINOCCHIO = """
import pinocchio
model = pinocchio.buildModelFromUrdf(path)
joints = [
    (model.names[i], int(model.idx_qs[i]), int(model.idx_vs[i])) for i in range(1, model.njoints)
]
bodies = {}
for i in range(1, model.njoints):
    one = model.inertias[i]
    first = next(
        frame.name for frame in model.frames
        if frame.parentJoint == i and frame.type == pinocchio.FrameType.BODY
    )
    bodies[first] = (one.mass, *map(float, one.lever), *map(float, one.inertia.flat))
"""

_PYBULLET = """
import pybullet
pybullet.connect(pybullet.DIRECT)
body = pybullet.loadURDF(path)
every = [pybullet.getJointInfo(body, i) for i in range(pybullet.getNumJoints(body))]
joints = [(one[1].decode(), one[3], one[4]) for one in every if one[3] >= 0]
bodies = {pybullet.getBodyInfo(body)[0].decode(): (pybullet.getDynamicsInfo(body, -1)[0],)}
for i, one in enumerate(every):
    bodies[one[12].decode()] = (pybullet.getDynamicsInfo(body, i)[0],)
"""

#: For each program a script that sets ``joints`` (name, q, v) and ``bodies`` (mass, and where the
#: program tells: centre of mass and tensor, nine entries) for the URDF at ``path``.
SCRIPTS = {"mujoco": _MUJOCO, "pinocchio": _PINOCCHIO, "pybullet": _PYBULLET}


def loaded(name: str, text: bytes, folder: Path) -> dict[str, Any] | None:
    """The joints and bodies of a robot in a program; None if it rejects the robot."""
    import pytest  # not in the process of the program

    if importlib.util.find_spec(name) is None:
        pytest.skip(f"{name} is not installed")
    path = folder / "robot.urdf"
    path.write_bytes(text)
    if run(_load, name, path):
        return None
    joints, bodies = json.loads(path.with_suffix(".json").read_bytes())
    return {"joints": [tuple(joint) for joint in joints], "bodies": bodies}


def _load(name: str, path: Path) -> None:
    """The process: what the program says is of no interest."""
    with open(os.devnull, "wb") as nowhere:
        for stream in (1, 2):
            os.dup2(nowhere.fileno(), stream)
    found: dict[str, Any] = {"path": str(path)}
    exec(SCRIPTS[name], found)
    made = json.dumps([found["joints"], found["bodies"]])
    path.with_suffix(".json").write_text(made, encoding="utf-8")
