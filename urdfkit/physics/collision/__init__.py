"""Self-collisions of a robot, measured with coal.

`collisions` samples configurations and gives the `Matrix` of pairs of links; `srdf_matrix` writes
it as MoveIt's SRDF has it. What the rules need stands in `contacts`.
"""
