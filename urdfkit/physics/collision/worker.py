"""The process that samples: it may crash in native code without taking the caller along.

It is sent the kinematic tree and the bodies, then one task after another.
"""

from urdfkit.core.child_process import Parent
from urdfkit.core.limits import limit_memory

#: Bytes that a process may take; a humanoid with large meshes takes a twentieth.
_MEMORY = 8 * 2**30


def main() -> None:
    """Answer until there are no more tasks."""
    limit_memory(_MEMORY)
    parent = Parent()
    from urdfkit.physics.collision.collision_geometry import build_geometry
    from urdfkit.physics.collision.pair_queries import CollisionModel

    received = parent.received()
    kinematics, bodies = next(received)
    geometries = []
    for body in bodies:
        geometries.append(build_geometry(body))
        parent.send(len(geometries))  # the caller learns which one was fatal
    collision_model = CollisionModel(kinematics, geometries)
    for task in received:
        parent.send(task.run(collision_model))
