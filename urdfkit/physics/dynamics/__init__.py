"""Dynamics by Pinocchio: the only gate to it. Import the modules in here where they are used."""
