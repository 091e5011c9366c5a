"""Read a URDF with another tool, in a process of its own.

Usage: peer.py TOOL FILE
"""

import sys


def yourdfpy(file: str) -> None:
    """Load without meshes."""
    from yourdfpy import URDF

    URDF.load(file, build_scene_graph=False, load_meshes=False, load_collision_meshes=False)


def pinocchio(file: str) -> None:
    """Build the model."""
    from pinocchio import buildModelFromUrdf

    buildModelFromUrdf(file)


if __name__ == "__main__":
    {"yourdfpy": yourdfpy, "pinocchio": pinocchio}[sys.argv[1]](sys.argv[2])
