"""Dynamics by Pinocchio, which only this package imports; import its modules inside functions."""
