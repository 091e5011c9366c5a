"""Self-collisions of a robot, computed with coal.

`collisions` samples configurations and returns the `Matrix` of pairs of links; `srdf_matrix` writes
it as MoveIt's SRDF. The checks use `contacts`.
"""
