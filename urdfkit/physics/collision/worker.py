"""The process that samples: it may crash in native code without taking the caller along.

Standard input brings pickled values: the chain and the bodies, then one task after another. The
answers go, pickled, to where standard output led; whatever the libraries print goes to standard
error.
"""

import os
import pickle
import sys
from typing import Any, BinaryIO

from urdfkit.core.limits import limit_memory

#: Bytes that a process may take; a humanoid with large meshes takes a twentieth.
_MEMORY = 8 * 2**30


def main() -> None:
    """Answer until standard input ends."""
    limit_memory(_MEMORY)
    answers = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)
    from urdfkit.physics.collision.collision_geometry import form
    from urdfkit.physics.collision.pair_queries import Examiner

    chain, solids = pickle.load(sys.stdin.buffer)
    forms = []
    for solid in solids:
        forms.append(form(solid))
        _send(answers, len(forms))  # the caller learns which one was fatal
    examiner = Examiner(chain, forms)
    while (task := _receive(sys.stdin.buffer)) is not None:
        _send(answers, task.run(examiner))


def _receive(tasks: BinaryIO) -> Any:
    try:
        return pickle.load(tasks)
    except EOFError:
        return None


def _send(answers: BinaryIO, value: object) -> None:
    pickle.dump(value, answers)
    answers.flush()
