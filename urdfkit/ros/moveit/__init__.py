"""MoveIt's files beside a robot: SRDF, joint limits, solvers and planners."""
