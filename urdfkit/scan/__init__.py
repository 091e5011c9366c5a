"""Checks of whole collections of models: rows in files, one process to crash, to be resumed."""
