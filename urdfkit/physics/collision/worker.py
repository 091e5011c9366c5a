"""The worker process for sampling: a crash in native code does not affect the caller.

It receives the kinematic tree and the bodies, then one task after another.
"""

from urdfkit.core.child_process import Parent
from urdfkit.core.limits import limit_memory

#: Memory limit in bytes; a humanoid with large meshes takes a twentieth.
_MEMORY = 8 * 2**30


def main() -> None:
    """Process tasks until there are no more."""
    limit_memory(_MEMORY)
    parent = Parent()
    from urdfkit.physics.collision.collision_geometry import build_geometries
    from urdfkit.physics.collision.pair_queries import CollisionModel

    received = parent.received()
    kinematics, bodies = next(received)
    geometries = []
    for geometry in build_geometries(bodies):
        geometries.append(geometry)
        parent.send(len(geometries))  # tells the caller which body causes a crash
    collision_model = CollisionModel(kinematics, geometries)
    for task in received:
        parent.send(task.run(collision_model))
