"""A language server: what editors show of a robot while it is being written.

``server`` and ``features`` speak the protocol and know nothing of robots; the other modules know
nothing of sockets and threads. ``workspace`` holds the texts that are not on disk and checks them;
a ``Robot`` is one description with everything that can be asked about it. ``markup`` and ``names``
read texts that are no XML yet; the remaining modules are one feature each.

Only this package uses pygls and lsprotocol, which the extra ``[lsp]`` brings.
"""
