"""MoveIt's files for a robot: SRDF, joint limits, solvers and planners."""
