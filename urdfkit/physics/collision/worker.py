"""The process that samples: it may crash in native code without taking the caller along.

It is sent the chain and the bodies, then one task after another.
"""

from urdfkit.core.child_process import Parent
from urdfkit.core.limits import limit_memory

#: Bytes that a process may take; a humanoid with large meshes takes a twentieth.
_MEMORY = 8 * 2**30


def main() -> None:
    """Answer until there are no more tasks."""
    limit_memory(_MEMORY)
    parent = Parent()
    from urdfkit.physics.collision.collision_geometry import form
    from urdfkit.physics.collision.pair_queries import Examiner

    received = parent.received()
    chain, solids = next(received)
    forms = []
    for solid in solids:
        forms.append(form(solid))
        parent.send(len(forms))  # the caller learns which one was fatal
    examiner = Examiner(chain, forms)
    for task in received:
        parent.send(task.run(examiner))
