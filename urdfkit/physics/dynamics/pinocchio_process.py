"""Pinocchio's URDF parser in a separate process: ``python pinocchio_process.py < robot.urdf``.

The parser may crash on malicious text, and writes its messages to standard error. The process
prints one line of JSON: ``{"error": reason}``, or the properties of the model.
"""

import json
import os
import sys

#: Limits of CPU time in seconds and memory in bytes; real robots need a tenth of a second.
SECONDS, MEMORY = 20, 4 * 2**30


def main() -> None:
    """Parse standard input and print the result."""
    _limit_resources()
    import pinocchio as pin

    text = sys.stdin.buffer.read().decode("utf-8", "replace")
    try:
        model = pin.buildModelFromXML(text, pin.JointModelFreeFlyer())
    except (ValueError, RuntimeError, MemoryError) as error:
        print(json.dumps({"error": f"{error}" or type(error).__name__}))
        return
    print(json.dumps(_facts(model)))


def _facts(model: object) -> dict[str, object]:
    """Properties of a model, without Pinocchio's Data, whose memory grows with joints cubed."""
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


def _limit_resources() -> None:
    """Limit the effect of malicious text to this process."""
    try:
        import resource
    except ImportError:  # Windows, where Pinocchio is not available either
        return
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS))
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))


if __name__ == "__main__":
    here = os.path.dirname(os.path.abspath(__file__))
    sys.path[:] = [path for path in sys.path if os.path.abspath(path or ".") != here]
    main()
