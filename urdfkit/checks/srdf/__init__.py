"""SRDF: MoveIt's groups, states and allowed-collision matrix."""
