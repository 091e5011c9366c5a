"""The language server: features of editors for robot descriptions.

``server`` and ``features`` implement the protocol; the other modules contain no sockets or
threads. ``workspace`` keeps and checks the open texts; an ``OpenRobot`` is a description with its
derived data. ``markup`` and ``names`` parse texts that are not well-formed yet; the remaining
modules are one feature each.

Only this package uses pygls and lsprotocol, from the extra ``[lsp]``.
"""
