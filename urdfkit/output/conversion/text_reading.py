"""A URDF as Pinocchio reads it, independent of urdfkit's model."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from contextlib import contextmanager

import numpy as np
import pinocchio as pin

from urdfkit.mesh.geometry import Floats
from urdfkit.robot.rigid_bodies import RigidBody


def read_text(text: bytes) -> TextReading | None:
    """Read a URDF without xacro; None if Pinocchio rejects it."""
    try:
        with _silenced():
            return TextReading(pin.buildModelFromXML(text.decode("utf-8", "replace")))
    except (ValueError, RuntimeError):
        return None


class TextReading:
    """Frames and masses of a URDF.

    Args:
        model: model of Pinocchio's reader, with the root fixed.
    """

    def __init__(self, model: pin.Model) -> None:
        self._model = model
        self._data = model.createData()

    def placements(self, positions: Mapping[str, float]) -> dict[str, Floats]:
        """Homogeneous matrices (4, 4) of the links in the frame of the root.

        Args:
            positions: of all joints with one degree of freedom, in rad or m.
        """
        q = pin.neutral(self._model)
        for number, name in enumerate(self._model.names):
            joint = self._model.joints[number]
            if name in positions and (joint.nq, joint.nv) == (2, 1):
                q[joint.idx_q : joint.idx_q + 2] = np.cos(positions[name]), np.sin(positions[name])
            elif name in positions and joint.nq == 1:
                q[joint.idx_q] = positions[name]
        pin.framesForwardKinematics(self._model, self._data, q)
        return {
            frame.name: self._data.oMf[number].homogeneous
            for number, frame in enumerate(self._model.frames)
            if frame.type == pin.FrameType.BODY
        }

    def inertia(self, body: RigidBody) -> Floats:
        """Pseudo-inertia of links that are fixed together, (4, 4), in the topmost link's frame."""
        number = self._model.getJointId(body.joint.name) if body.joint else 0
        return np.asarray(self._model.inertias[number].toPseudoInertia().toMatrix())


@contextmanager
def _silenced() -> Iterator[None]:
    """Discard the standard error of the process, to which urdfdom writes its errors."""
    stderr = os.dup(2)
    with open(os.devnull, "wb") as null:
        os.dup2(null.fileno(), 2)
    try:
        yield
    finally:
        os.dup2(stderr, 2)
        os.close(stderr)
