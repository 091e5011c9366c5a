"""Pinocchio's own reading of a URDF, in a process of its own: ``python child.py < robot.urdf``.

Its parser may crash on hostile text, and writes its reasons to the standard error of the process.
Prints one line of JSON: ``{"error": reason}``, or the facts of the model.
"""

import json
import os
import sys

#: Seconds of computing and bytes of memory; real robots need a tenth of a second.
SECONDS, MEMORY = 20, 4 * 2**30


def main() -> None:
    """Read standard input and print what it makes."""
    _bound()
    import pinocchio as pin

    text = sys.stdin.buffer.read().decode("utf-8", "replace")
    try:
        model = pin.buildModelFromXML(text, pin.JointModelFreeFlyer())
    except (ValueError, RuntimeError, MemoryError) as error:
        print(json.dumps({"error": f"{error}" or type(error).__name__}))
        return
    print(json.dumps(_facts(model)))


def _facts(model: object) -> dict[str, object]:
    """Facts of a model without Pinocchio's Data: its memory grows with the cube of the joints."""
    import numpy as np
    import pinocchio as pin

    assert isinstance(model, pin.Model)
    placed = [pin.SE3.Identity()]
    mass, moment = 0.0, np.zeros(3)
    for number in range(1, model.njoints):
        at = placed[model.parents[number]] * model.jointPlacements[number]
        placed.append(at)
        body = model.inertias[number]
        mass += body.mass
        moment += body.mass * at.act(body.lever)
    center = (moment / mass).tolist() if mass else [0.0, 0.0, 0.0]
    return {"nq": model.nq - 7, "nv": model.nv - 6, "mass": mass, "center": center}


def _bound() -> None:
    """Hostile text ends this process, and nothing else."""
    try:
        import resource
    except ImportError:  # Windows, for which there is no Pinocchio either
        return
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS))
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))


if __name__ == "__main__":
    here = os.path.dirname(os.path.abspath(__file__))
    sys.path[:] = [path for path in sys.path if os.path.abspath(path or ".") != here]
    main()
