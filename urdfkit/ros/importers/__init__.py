"""Robots as simulators and dynamics libraries import them: bodies, masses, order of the joints.

``catalog/importers/`` has the facts about each program; the programs are not required.
"""
