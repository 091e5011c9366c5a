"""What simulators and dynamics libraries make of a URDF: bodies, masses, order of the joints.

``catalog/importers/`` has the facts about each program; nothing here needs the program.
"""
